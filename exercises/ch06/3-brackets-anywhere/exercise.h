// Exercise: brackets anywhere
#pragma once
#include <stdbool.h>
#include <stdint.h>

// A stretch of elements, each of which may begin a segment.
struct stretch {
    bool begins;    // whether a segment begins anywhere in it
    uint32_t total; // of its values since the last one began
};
struct stretch no_stretch(void); // without any elements
struct stretch join_stretches(struct stretch left,
                              struct stretch right);

// Some steps x = factor * x + offset, one after the other, as one.
struct steps {
    uint32_t factor, offset;
};
struct steps no_steps(void);
struct steps join_steps(struct steps first, struct steps second);
