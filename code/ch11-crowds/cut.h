//> Declare the cut
// Parts a list of points into two of about the same length, by a
// coordinate. The cut is near the median of the longer side of their
// box, neither part having less than an eighth of them. But equal
// coordinates stay together: where most are equal, one cut parts them
// from what is below, the next from what is above. Linear time,
// expected over our own random choices, whatever the points are.
#pragma once
#include <stdbool.h>
#include <stdint.h>

//> Pack a point to be cut
struct point_record {
    double x, y;
    uint32_t cell, point;
};
//<

//> Hold a box
struct box {
    double left, right, bottom, top;
};
//<

static inline bool box_is_place(const struct box *box)
{
    return box->left == box->right && box->bottom == box->top;
}

// The box of the records that are listed; an empty one has its left at
// INFINITY and its right at -INFINITY.
struct box box_of(const struct point_record *record,
                  const uint32_t *list, uint32_t n);

//> Hold a cut
struct cut {
    bool by_y;
    double at; // what is less than this comes first
};
//<

//> Hold room for a cut
// For as many values and numbers as there are points in the list.
struct cut_room {
    double *values;
    uint32_t *numbers;
};
//<

// Orders list[0 .. n-1], numbers of records in this box that are not
// all in one place, so that what is less than the cut comes first, and
// says how many these are, at least 1 and at most n - 1.
uint32_t cut_list(const struct point_record *record, uint32_t *list,
                  uint32_t n, const struct box *box,
                  struct cut_room room, struct cut *cut);
//<
