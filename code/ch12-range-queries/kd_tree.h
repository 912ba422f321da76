//> Declare the k-d tree
// Bentley's tree (1975), cut at the median of the coordinate with the
// largest spread (Friedman, Bentley and Finkel, 1977) until a leaf has
// few points. All leaves are at the same depth, so the tree needs no
// pointers: it is three arrays and the points in order.
#pragma once
#include "ch12-range-queries/neighbors.h"
#include "ch12-range-queries/scan.h"

//> Hold the k-d tree
// The two below node i are 2 i and 2 i + 1; node 1 is the root. Nodes
// from leaves on are the leaves. Leaf l has the places from l n /
// leaves to (l + 1) n / leaves, rounded down.
struct kd_tree {
    struct sorted_points sorted;
    struct range range; // of all points
    uint32_t leaves;    // 2^depth
    int depth;
    int threads;
    uint8_t *axis;     // of node i: the coordinate that it cuts
    double *left_high; // the greatest number there to its left
    double *right_low; // and the least to its right
};
//<

// At most so many points in a leaf are usual.
enum { KD_LEAF_SIZE = 16 };

// With leaves of at most leaf_size points, at least two; so many
// threads build it. The points are copied. Released with kd_free.
struct kd_tree kd_make(const struct point_set *points,
                       uint32_t leaf_size, int threads);
void kd_free(struct kd_tree *tree);
size_t kd_bytes(const struct kd_tree *tree);

// The points have moved. Refit keeps the tree, and what a leaf holds,
// and finds new bounds, in linear time: queries stay right, but become
// slower. Rebuild makes it anew, from the order that it has.
void kd_refit(struct kd_tree *tree, const struct point_set *points);
void kd_rebuild(struct kd_tree *tree, const struct point_set *points);

void kd_query(const struct kd_tree *tree, const struct range *range,
              struct report *report);
void kd_neighbors(const struct kd_tree *tree,
                  struct neighbor_query *query);

//> Find the places of a leaf
static inline struct span kd_leaf(const struct kd_tree *tree,
                                  uint32_t leaf)
{
    const uint64_t n = tree->sorted.points.n;
    return (struct span){(uint32_t)(leaf * n / tree->leaves),
                         (uint32_t)((leaf + 1) * n / tree->leaves)};
}
//<
//<
