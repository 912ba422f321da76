//> Declare the search by divide and conquer
// Nearest neighbors by divide and conquer (Shamos and Hoey 1975):
// the points are halved by x, each half is searched by itself, and what
// is near the border is compared over it, in the order of y. n log n
// steps at worst, if the squared distances of different places do not
// vanish. It is slower than the search by pieces on all points that we
// know, and stands behind it for those that we do not.
#pragma once
#include "common/question.h"
#include "common/workspace.h"

// Answers for the points query[0 .. count-1] of the question, by its
// threads, and writes their neighbors to answers. What it needs is
// taken from the workspace and given back.
void search_divide_and_conquer(const struct question *question,
                               const uint32_t *query, uint32_t count,
                               struct workspace *workspace,
                               struct answers *answers);
//<
