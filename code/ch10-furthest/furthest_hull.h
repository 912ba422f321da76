//> Declare the search among the corners
// Every query is compared with all corners of the hull: n times as many
// distances as there are corners, n^2 on a circle.
#pragma once
#include "ch10-furthest/hull.h"

// The furthest of these corners for every point of the question, by its
// threads.
void search_corners(const struct question *question,
                    const struct corners *corners,
                    struct answers *answers);

// The row of the table: finds the corners, and searches them.
search_function furthest_hull;
//<
