// Exercise: refit the tree
#pragma once
#include <stdint.h>

// A coordinate, 0 or 1, of the point at a place. Given; it counts.
double number_at(uint32_t place, int axis);

// A k-d tree of n points in the plane. The nodes below node i are 2 i
// and 2 i + 1, the root is node 1, and nodes leaves to 2 leaves - 1 are
// the leaves. Leaf l, node leaves + l, has the places l n / leaves to
// (l + 1) n / leaves - 1, both divisions rounded down, at least one.
struct tree {
    uint32_t n, leaves;  // leaves is a power of two
    const uint8_t *axis; // of nodes 1 to leaves - 1
    double *left_high;   // the greatest number of that axis, left
    double *right_low;   // the least of that axis, right
};

// Computes left_high and right_low of all nodes that are no leaves.
void refit(const struct tree *tree);
