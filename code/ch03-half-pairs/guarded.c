//> Guard what threads share
// The triangular loop on several threads that share one set of bests:
// n (n-1) / 2 distances and four offers for each. The loop is written
// once; what differs is how a distance is offered. It is copied for
// each kind of offer, so that none is called through a pointer.
#include "ch03-half-pairs/guarded.h"
#include "ch02-all-pairs/pair.h"
#include "ch03-half-pairs/best.h"

//> Offer every distance to both ends
typedef void offer_function(struct best *best, double key,
                            uint32_t index);

// Called by all threads of a parallel region, which share the rows.
INLINED void share_rows(const enum geometry geometry,
                        const struct question *question,
                        struct bests bests, offer_function *offer)
{
    const struct points p = question->points;
#pragma omp for schedule(dynamic, 32)
    for (uint32_t i = 0; i < p.n; i++) {
        for (uint32_t j = i + 1; j < p.n; j++) {
            struct pair_distances pair =
                pair2(geometry, question->space, p.x[j] - p.x[i],
                      p.y[j] - p.y[i]);
            offer(&bests.near[i], pair.near2, j);
            offer(&bests.near[j], pair.near2, i);
            offer(&bests.far[i], -pair.far2, j);
            offer(&bests.far[j], -pair.far2, i);
        }
        counts_add(question->counts,
                   &(struct counts){.distances = p.n - 1 - i});
    }
}
//<

//> Copy the bests into the answers
static void copy_to_answers(struct bests *bests, uint32_t n,
                            struct answers *answers)
{
    for (uint32_t i = 0; i < n; i++) {
        answers->nearest[i] = bests->near[i].index;
        answers->nearest2[i] = bests->near[i].key;
        answers->furthest[i] = bests->far[i].index;
        answers->furthest2[i] = -bests->far[i].key;
    }
    bests_free(bests);
}
//<

//> Let one thread at a time look
void triangle_locked(const struct question *question,
                     struct answers *answers)
{
    struct bests bests = bests_begin(question->points.n);
#pragma omp parallel num_threads(question->threads)
    IN_GEOMETRY(question->space, share_rows, question, bests,
                offer_locked);
    copy_to_answers(&bests, question->points.n, answers);
}
//<

//> Let threads look before they queue
void triangle_critical(const struct question *question,
                       struct answers *answers)
{
    struct bests bests = bests_begin(question->points.n);
#pragma omp parallel num_threads(question->threads)
    IN_GEOMETRY(question->space, share_rows, question, bests,
                offer_critical);
    copy_to_answers(&bests, question->points.n, answers);
}
//<

//> Let every best be its own lock
void triangle_atomic(const struct question *question,
                     struct answers *answers)
{
    struct bests bests = bests_begin(question->points.n);
#pragma omp parallel num_threads(question->threads)
    IN_GEOMETRY(question->space, share_rows, question, bests,
                offer_atomic);
    copy_to_answers(&bests, question->points.n, answers);
}
//<
//<
