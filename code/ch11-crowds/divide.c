//> Search by divide and conquer
// A place compares itself, over the border, with those places of the
// other half that its circle reaches as far as y and the border can
// tell. No more than five circles of a half cover a place on the
// border, so a join of n places takes a few n steps.
#include "ch11-crowds/divide.h"
#include "common/min_max.h"
#include <stdbool.h>
#include <stdlib.h>

//> Hold a place
// Where one point is or several: the lowest index and the next.
struct place {
    double x, y, best2;
    uint32_t lowest, second, nearest;
    bool is_query; // its answer is wanted
};

struct halving {
    struct space space;
    struct place *place; // from left to right
    uint32_t *up, *room; // numbers of places, each half from below
    struct counts *counts;
};

struct span {
    uint32_t begin, end; // places begin to end - 1
};
//<

//> Compare two places
static void compare(const struct halving *halving, struct place *p,
                    const struct place *q)
{
    const double near2 =
        closest2(halving->space, q->x - p->x, q->y - p->y);
    if (near2 < p->best2 ||
        (near2 == p->best2 && q->lowest < p->nearest)) {
        p->best2 = near2;
        p->nearest = q->lowest;
    }
}
//<

//> Walk up, or down
// From place k of the other half on, up to its end, as long as
// something there may be as near, if it is right at the border. Says
// how many it has compared.
struct offset {
    double across, over; // to the border; the period, if over the seam
};

static uint32_t walk_on(const struct halving *halving, struct place *p,
                        struct span other, int64_t k, int step,
                        struct offset at)
{
    uint32_t steps = 0;
    for (; k >= other.begin && k < other.end; k += step, steps++) {
        const struct place *q = &halving->place[halving->up[k]];
        const double apart = at.over + step * (q->y - p->y);
        if (distance2(at.across, apart) > p->best2)
            break;
        if (q != p)
            compare(halving, p, q);
    }
    return steps;
}

// With wraparound once more, from the other end: there the place is
// seen over the seam.
static uint32_t walk(const struct halving *halving, struct place *p,
                     struct span other, int64_t k, int step,
                     double across)
{
    uint32_t steps =
        walk_on(halving, p, other, k, step, (struct offset){across, 0});
    if (halving->space.geometry == WRAPAROUND)
        steps += walk_on(
            halving, p, other,
            step > 0 ? other.begin : (int64_t)other.end - 1, step,
            (struct offset){across, halving->space.height});
    return steps;
}
//<

//> Search over the border
// For all places of one half, among those of the other. Nothing there
// is nearer, across, than the border is.
static uint64_t search_over(const struct halving *halving,
                            struct span these, struct span other,
                            double border)
{
    uint64_t distances = 0;
    uint32_t k = other.begin;
    for (uint32_t i = these.begin; i < these.end; i++) {
        struct place *p = &halving->place[halving->up[i]];
        while (k < other.end && halving->place[halving->up[k]].y < p->y)
            k++;
        const double across = border - p->x;
        if (p->is_query && !(across * across > p->best2)) {
            distances += walk(halving, p, other, k, 1, across);
            distances +=
                walk(halving, p, other, (int64_t)k - 1, -1, across);
        }
    }
    return distances;
}
//<

//> Merge both halves from below
static void merge(const struct halving *halving, struct span half,
                  struct span other)
{
    uint32_t *up = halving->up, *room = halving->room;
    uint32_t i = half.begin, k = other.begin;
    for (uint32_t to = half.begin; to < other.end; to++) {
        const bool first =
            k == other.end ||
            (i < half.end &&
             halving->place[up[i]].y <= halving->place[up[k]].y);
        room[to] = first ? up[i++] : up[k++];
    }
    for (uint32_t to = half.begin; to < other.end; to++)
        up[to] = room[to];
}
//<

//> Divide and join
enum { WORTH_A_TASK = 1 << 13 };
static void divide(const struct halving *halving, struct span span)
{
    const uint32_t middle = span.begin + (span.end - span.begin) / 2;
    const struct span half = {span.begin, middle},
                      other = {middle, span.end};
    if (span.end - span.begin == 1) {
        halving->up[span.begin] = span.begin;
        return;
    }
#pragma omp task if (span.end - span.begin > WORTH_A_TASK)
    divide(halving, half);
    divide(halving, other);
#pragma omp taskwait
    struct counts counts = {0};
    counts.distances =
        search_over(halving, half, other, halving->place[middle].x) +
        search_over(halving, other, half, halving->place[middle - 1].x);
    counts_add(halving->counts, &counts);
    merge(halving, half, other);
}
//<

//> Search over the seam
// To the right of the rightmost place lies the leftmost again.
static void search_over_seam(const struct halving *halving, uint32_t n)
{
    const struct span all = {0, n};
    const double left = halving->place[0].x;
    const double right = halving->place[n - 1].x;
    struct counts counts = {0};
    for (uint32_t k = 0; k < n; k++) {
        struct place *p = &halving->place[halving->up[k]];
        const double across =
            halving->space.width - MAX(right - p->x, p->x - left);
        if (p->is_query && !(across * across > p->best2)) {
            counts.distances += walk(halving, p, all, k, 1, across);
            counts.distances +=
                walk(halving, p, all, (int64_t)k - 1, -1, across);
        }
    }
    counts_add(halving->counts, &counts);
}
//<

//> Gather the places
static int from_left(const void *one, const void *other)
{
    const struct place *a = one, *b = other;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    if (a->y != b->y)
        return a->y < b->y ? -1 : 1;
    return (a->lowest > b->lowest) - (a->lowest < b->lowest);
}

// Says where each point's place is, and how many there are.
static uint32_t gather(struct place *place, struct points p,
                       uint32_t *where)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < p.n; i++)
        place[i] = (struct place){p.x[i],   p.y[i],   INFINITY, i,
                                  NO_INDEX, NO_INDEX, false};
    qsort(place, p.n, sizeof *place, from_left);
    for (uint32_t k = 0; k < p.n; k++) {
        struct place *last = &place[count - (count > 0)];
        const uint32_t i = place[k].lowest;
        if (k > 0 && place[k].x == last->x && place[k].y == last->y) {
            last->second = MIN(i, last->second);
            last->best2 = 0;
        } else {
            place[count++] = place[k];
        }
        where[i] = count - 1;
    }
    return count;
}
//<

//> Answer for a point
// Its own place may have another, at distance 0.
static void answer(const struct place *place, uint32_t i,
                   struct answers *answers)
{
    uint32_t beside =
        place->lowest != i ? place->lowest : place->second;
    answers->nearest[i] = place->nearest;
    answers->nearest2[i] = place->best2;
    if (beside != NO_INDEX)
        answers->nearest[i] = MIN(beside, place->nearest);
}
//<

void search_divide_and_conquer(const struct question *question,
                               const uint32_t *query, uint32_t count,
                               struct workspace *workspace,
                               struct answers *answers)
{
    const uint32_t n = question->points.n;
    struct mark mark = workspace_mark(workspace);
    uint32_t *where = workspace_take(workspace, n, sizeof *where);
    struct halving halving = {
        question->space,
        workspace_take(workspace, n, sizeof(struct place)),
        workspace_take(workspace, n, sizeof(uint32_t)),
        workspace_take(workspace, n, sizeof(uint32_t)),
        question->counts};
    const uint32_t m = gather(halving.place, question->points, where);
    for (uint32_t k = 0; k < count; k++)
        halving.place[where[query[k]]].is_query = true;
#pragma omp parallel num_threads(question->threads)
#pragma omp single
    divide(&halving, (struct span){0, m});
    if (question->space.geometry == WRAPAROUND)
        search_over_seam(&halving, m);
    for (uint32_t k = 0; k < count; k++)
        answer(&halving.place[where[query[k]]], query[k], answers);
    workspace_release(workspace, mark);
}
//<
