//> Declare the capture boxes
// A box for each triangle that it does not leave during a step.
#pragma once
#include "ch13-contact/scene.h"
#include <stdbool.h>

//> Hold boxes
struct boxes {
    uint32_t n, room;
    double *low[3], *high[3]; // low[k][t]: of triangle t
};
//<

// The boxes of all triangles over the step from mesh.x to predicted;
// the room for them is kept from step to step. {0} is empty; released
// with boxes_free. Two triangles have a contact event at this tolerance
// (events.h) only if their boxes meet.
void capture(struct boxes *boxes, const struct scene *scene,
             double tolerance, int threads);
void boxes_reserve(struct boxes *boxes, uint32_t n);
void boxes_free(struct boxes *boxes);

// Makes box i of to the smallest around boxes begin to end - 1 of of.
void boxes_unite(struct boxes *to, uint32_t i, const struct boxes *of,
                 uint32_t begin, uint32_t end);

//> Test whether two boxes meet
// Box i of the ones and box j of the others. To touch is to meet.
static inline bool box_meets(const struct boxes *ones, uint32_t i,
                             const struct boxes *others, uint32_t j)
{
    bool meet = true;
    for (int k = 0; k < 3; k++)
        meet &= (ones->low[k][i] <= others->high[k][j]) &
                (others->low[k][j] <= ones->high[k][i]);
    return meet;
}
//<
//<
