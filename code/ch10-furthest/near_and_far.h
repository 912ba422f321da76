//> Declare the search near and far
// Both halves of the question: the nearest by row spans, the furthest
// by the regions of the corners, or with wraparound by batches. About
// 9 c + 23 distances a point, c points in a cell, if the points are
// spread evenly; with wraparound twice as many.
#pragma once
#include "common/question.h"

// The row of the table. A half whose arrays in answers are NULL is
// left out.
void near_and_far(const struct question *question,
                  struct answers *answers);
//<
