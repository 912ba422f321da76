//> Declare the search near and far
// Both halves of the question: the nearest by row spans, the furthest
// by the corners' candidate grid, or with wraparound by batches, too.
// About 9 c + 23 distances a point, c points in a cell, if the points
// are spread evenly; with wraparound twice as many.
#pragma once
#include "common/question.h"

// The row of the table. A half whose arrays in answers are NULL is
// left out.
search_function near_and_far;
//<
