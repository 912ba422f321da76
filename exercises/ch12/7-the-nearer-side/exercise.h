// Exercise: the nearer side first
#pragma once
#include <stdint.h>

// The least squared distance from the place to a point of the leaf.
// Given; it counts.
double measure_leaf(uint32_t leaf);

// A k-d tree in the plane. The nodes below node i are 2 i and 2 i + 1,
// the root is node 1, and node leaves + l is leaf l.
struct tree {
    uint32_t leaves;         // a power of two
    const uint8_t *axis;     // of nodes 1 to leaves - 1: 0 for x
    const double *left_high; // the greatest number there to the left
    const double *right_low; // and the least to the right
};

// The least squared distance from the place to any point of the tree.
double nearest2(const struct tree *tree, const double place[2]);
