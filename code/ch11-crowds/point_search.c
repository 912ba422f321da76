//> Search all pieces for one point
// The points beside the query in memory are compared first: they give a
// bound that is nearly right, and the tree of boxes has little to do.
#include "ch11-crowds/point_search.h"
#include "ch09-row-spans/span_kernels.h"

//> Begin and end a search for one point
// Points that are next to the query in memory are in its cell or in
// the next ones: so many on either side.
enum { BESIDE = 4 };

struct tree_query query_for(const struct scene *all,
                            const struct pieces *pieces, uint32_t s,
                            uint64_t max_steps)
{
    return (struct tree_query){.pieces = pieces,
                               .all = all,
                               .query = query_of(all->sorted, s),
                               .max_steps = max_steps};
}

struct neighbor answer_of(const struct tree_query *query, bool found,
                          struct counts *counts)
{
    counts->distances += query->query.compared;
    return (struct neighbor){query->query.best2,
                             found ? query->query.nearest : NO_INDEX};
}

uint32_t beside_begin(uint32_t s)
{
    return s > BESIDE ? s - BESIDE : 0;
}

uint32_t beside_end(uint32_t s, uint32_t n)
{
    return n - s > BESIDE ? s + BESIDE + 1 : n;
}

struct scene scene_of(const struct question *question,
                      const struct pieces *pieces)
{
    return (struct scene){question->space, &pieces->sorted,
                          span_kernels()};
}
//<

//> Search near or far for one point
struct neighbor nearest_of_all(const struct scene *all,
                               const struct pieces *pieces, uint32_t s,
                               uint64_t max_steps,
                               struct counts *counts)
{
    struct tree_query query = query_for(all, pieces, s, max_steps);
    compare_nearest(&query, beside_begin(s),
                    beside_end(s, pieces->sorted.points.n));
    return answer_of(&query, query_nearest(&query), counts);
}

struct neighbor furthest_of_all(const struct scene *all,
                                const struct pieces *pieces, uint32_t s,
                                struct counts *counts)
{
    struct tree_query query = query_for(all, pieces, s, UINT64_MAX);
    compare_furthest(&query, beside_begin(s),
                     beside_end(s, pieces->sorted.points.n));
    struct neighbor found =
        answer_of(&query, query_furthest(&query), counts);
    found.distance2 = -found.distance2;
    return found;
}
//<
//<
