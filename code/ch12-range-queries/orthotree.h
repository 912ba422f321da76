//> Declare the orthotree
// Cut at the midpoint along all d coordinates at once: 2^d children
// of equal size, quadtree (Finkel and Bentley, 1974) and octree. Points
// are sorted by Morton's numbering (1966), in which each node is a
// stretch. The compressed form has no empty nodes, and none with only
// one child.
#pragma once
#include "ch12-range-queries/scan.h"

//> Hold a node of the orthotree
struct ortho_node {
    uint64_t key;        // Morton number of its first point
    uint32_t begin, end; // places of its points
    uint32_t first_child;
    uint16_t children; // how many; 0: a leaf
    uint16_t level;    // how often space was halved
};
//<

//> Hold the orthotree
struct orthotree {
    struct sorted_points sorted;
    struct range range; // of all points
    double scale[MAX_DIMENSIONS];
    int levels;         // 2^levels bins along each coordinate
    uint32_t leaf_size; // a leaf has no more points
    bool compressed;
    struct ortho_node *node; // the root is the first
    uint32_t count, room;    // of nodes
};
//<

enum { ORTHO_LEAF_SIZE = 16, MAX_LEVELS = 32 };

// Nodes of more than leaf_size points are cut, down to as many levels
// as a Morton number of 64 bits has: closer points share a leaf. The
// points are copied. Released with ortho_free.
struct orthotree ortho_make(const struct point_set *points,
                            uint32_t leaf_size, bool compressed);
void ortho_free(struct orthotree *tree);
size_t ortho_bytes(const struct orthotree *tree);

void ortho_query(const struct orthotree *tree,
                 const struct range *range, struct report *report);

//> Find the bin of a number
// The bin of a number along coordinate k, 0 to 2^levels - 1; never
// falls where the number grows.
static inline uint32_t bin_along(const struct orthotree *tree, int k,
                                 double x)
{
    const double bin = (x - tree->range.low[k]) * tree->scale[k];
    const double last = (double)(((uint64_t)1 << tree->levels) - 1);
    return bin >= last ? (uint32_t)last : bin > 0 ? (uint32_t)bin : 0;
}
//<

//> Find the child of a Morton number
// Which child of a node of this level a Morton number is in: bit k says
// that it is in the upper half of coordinate k.
static inline uint32_t child_of(const struct orthotree *tree,
                                uint64_t key, int level)
{
    const int d = tree->sorted.points.d;
    return key >> (tree->levels - 1 - level) * d & ((1u << d) - 1);
}
//<
//<
