// Exercise: boxes in lanes
#pragma once
#include <stdint.h>

struct box {
    double low[3], high[3];
};

struct boxes {
    uint32_t n;
    const double *low[3], *high[3]; // low[k][i]: of box i
};

// Writes the numbers of the boxes that meet the given one, lowest
// first, and returns how many there are. There is room for n.
uint32_t find_meeting(struct boxes boxes, const struct box *box,
                      uint32_t *found);
