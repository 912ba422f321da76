//> Test without motion
// The pairs of a broad phase, one by one, each by 15 signs at most;
// those that share a node are neighbors in their body.
#include "ch13-contact/static_test.h"
#include "ch13-contact/triangle_pair.h"

//> Count the pairs that meet now
static bool share_a_node(const struct mesh *mesh, struct pair pair)
{
    bool share = false;
    for (int c = 0; c < 9; c++)
        share |= mesh->corner[pair.one][c / 3] ==
                 mesh->corner[pair.other][c % 3];
    return share;
}

static struct triangle triangle_of(const struct mesh *mesh, uint32_t t)
{
    struct triangle triangle;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            triangle.corner[c][k] = mesh->x[k][mesh->corner[t][c]];
    return triangle;
}
//<

//> Ask whether a pair meets
static bool pair_meets(const struct mesh *mesh, struct pair pair)
{
    if (share_a_node(mesh, pair))
        return false;
    const struct triangle one = triangle_of(mesh, pair.one);
    const struct triangle other = triangle_of(mesh, pair.other);
    return triangles_meet(&one, &other, NULL);
}

uint64_t count_meeting(const struct scene *scene,
                       const struct pairs *pairs, int threads)
{
    uint64_t count = 0;
#pragma omp parallel for num_threads(threads) if (threads > 1) \
    reduction(+ : count)
    for (uint64_t p = 0; p < pairs->count; p++)
        count += pair_meets(&scene->mesh, pairs->pair[p]);
    return count;
}
//<

//> Find the first pair that meets
uint64_t first_meeting(const struct scene *scene,
                       const struct pairs *pairs)
{
    uint64_t p = 0;
    while (p < pairs->count &&
           !pair_meets(&scene->mesh, pairs->pair[p]))
        p++;
    return p;
}
//<
//<
