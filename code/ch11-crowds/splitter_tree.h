//> Declare the splitter tree
// A tree of cuts through a sample, the splitters, sends every point to
// one of 2^depth leaves, each with about as many of the points: one
// pass, depth steps a point. Frazer and McKellar's samplesort (1970),
// in the plane.
#pragma once
#include "ch11-crowds/cut.h"
#include "common/points.h"
#include "common/workspace.h"

//> Hold the splitter tree
// A complete binary tree: the two below node k are 2 k + 1 and 2 k + 2,
// and a point goes to the second if neither coordinate is less than the
// node's cut. At least one of the two cuts is -INFINITY.
struct splitter_tree {
    uint32_t depth, leaves; // leaves = 2^depth
    double *x, *y;          // of leaves - 1 nodes
    struct box *region;     // of each leaf, open to INFINITY
};
//<

// So many points of the sample are meant for a leaf. It then has as
// many points as the mean, give or take two fifths: its share of the
// sample is random, and so are the few by which the sample is cut.
enum { SAMPLE_PER_LEAF = 32, DEEPEST_LEAF = 14 };

// For pieces of so many points on average. All arrays are taken from
// the workspace.
struct splitter_tree splitter_tree_make(struct points points,
                                        uint32_t per_piece,
                                        struct workspace *workspace);

// Finds the leaves of count points.
void splitter_tree_find(const struct splitter_tree *tree,
                        const double *x, const double *y,
                        uint32_t count, uint32_t *leaf);
//<
