//> Declare the pieces
// A partition that adapts: the points are sent to the leaves of a
// splitter tree, each leaf is cut again for as long as its points
// crowd, and what is left, a piece, has points spread evenly enough for
// a grid of its own, or all in one place. A tree of boxes over the
// pieces says where else a query has to look. n log n steps, whatever
// the points are; most of them in a cache.
#pragma once
#include "ch04-cell-sort/sorted.h"
#include "ch11-crowds/splitter_tree.h"
#include "common/workspace.h"

//> Hold a piece
// Its points are a stretch of all sorted points, begin and following.
// Points in one place, or as good as in one, have no grid.
struct piece {
    struct sorted sorted; // its own points, its grid
    struct box region;    // no point of another piece is inside
    uint32_t begin;
    uint32_t lowest, second; // the two lowest indices of its points
    bool is_place;           // all squared distances in it are 0
};
//<

//> Hold a node of the tree of boxes
struct node {
    struct box box;                     // just around its points
    uint32_t lowest;                    // of their indices
    uint32_t first_child, second_child; // 0: there are none
    uint32_t piece;                     // if there are none
};
//<

//> Bound the depth of the tree
// No node is further from the root, whatever the points are: 14 levels
// at most are those of the sample, and below a leaf of m points there
// are fewer than 18 log2 (m / 96) + 6, since a cut takes off a ninth,
// or else most coordinates are equal, which ends after a few cuts.
enum { DEEPEST = 512 };
//<

//> Hold the pieces
// The leaf k of the splitter tree has become the pieces first[k] .. +
// count[k] - 1, in the order of the sorted points.
struct pieces {
    struct sorted sorted; // all, by piece, and there by cell; no grid
    uint32_t *permutation, *inverse; // as in chapter 5's partition
    struct node *node;               // node[0] is the root
    struct piece *piece;
    uint32_t leaves, *first, *count;
};
//<

// All arrays are taken from the workspace, where the caller keeps a
// mark. By the question's threads; the geometry does not matter.
struct pieces pieces_make(const struct question *question,
                          struct workspace *workspace);
//<
