//> Measure every distance once
// Row i compares point i with the points after it, so that each pair is
// measured in one row only. A distance is offered to both ends: half of
// the distances, and twice as many bests to load and store for each.
#include "ch03-half-pairs/triangle.h"
#include "ch02-all-pairs/pair.h"

//> Begin with the worst possible neighbors
void triangle_begin(struct answers *answers, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        answers->nearest[i] = answers->furthest[i] = i == 0;
        answers->nearest2[i] = INFINITY;
        answers->furthest2[i] = 0;
    }
}
//<

//> Offer a neighbor to one end
static inline void offer(struct answers *answers, uint32_t i,
                         uint32_t j, struct pair_distances pair)
{
    if (pair.near2 < answers->nearest2[i]) {
        answers->nearest2[i] = pair.near2;
        answers->nearest[i] = j;
    }
    if (pair.far2 > answers->furthest2[i]) {
        answers->furthest2[i] = pair.far2;
        answers->furthest[i] = j;
    }
}
//<

//> Measure one point against those after it
INLINED void row(const enum geometry geometry,
                 const struct question *question,
                 struct answers *answers, uint32_t i)
{
    const struct points p = question->points;
    for (uint32_t j = i + 1; j < p.n; j++) {
        struct pair_distances pair =
            pair2(geometry, question->space, p.x[j] - p.x[i],
                  p.y[j] - p.y[i]);
        offer(answers, i, j, pair);
        offer(answers, j, i, pair);
    }
    counts_add(question->counts,
               &(struct counts){.distances = p.n - 1 - i});
}
//<

//> Make the geometry a constant of the row
void triangle_row(const struct question *question,
                  struct answers *answers, uint32_t i)
{
    IN_GEOMETRY(question->space, row, question, answers, i);
}
//<

//> Walk down the triangle
void triangle(const struct question *question, struct answers *answers)
{
    uint32_t n = question->points.n;
    triangle_begin(answers, n);
    for (uint32_t i = 0; i < n; i++)
        triangle_row(question, answers, i);
}
//<
//<
