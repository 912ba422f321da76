//> Declare the stack of boxes
// A search down the tree of boxes keeps those that wait on a stack, and
// takes the last one: so it goes down before it goes across.
#pragma once
#include "ch11-crowds/pieces.h"
#include <assert.h>

//> Hold the boxes that wait
struct waiting {
    double bound;
    uint32_t node;
};

struct node_stack {
    int height;
    struct waiting waiting[DEEPEST + 1];
};
//<

//> Put both children on the stack, the better one last
static inline void push_children(struct node_stack *stack,
                                 struct waiting a, struct waiting b)
{
    const bool swap = a.bound < b.bound;
    assert(stack->height < DEEPEST && "the depth is bounded");
    stack->waiting[stack->height++] = swap ? b : a;
    stack->waiting[stack->height++] = swap ? a : b;
}
//<
//<
