//> Declare the reader of files
// Points from a text file: a table of numbers, or TSPLIB.
//
// A table has a point a line, its numbers separated by semicolons, or
// else by commas, or else by spaces and tabs, however many. What
// follows a '#' is a comment, empty lines do not count, and the first
// line may be a header of words. A table of more than two columns needs
// to be told which two. TSPLIB files are known by their first line,
// "KEYWORD : VALUE"; their NODE_COORD_SECTION must hold as many points
// as DIMENSION says.
#pragma once
#include "common/points.h"

// Which columns of a table hold x and y, counted from 1; both 0: there
// are no others.
struct columns {
    int x, y;
};

// The points of the file of this name, or of standard input for "-".
// All coordinates are finite; there is at least one point. The caller
// releases them with points_free. Fails with the name of the file, the
// line, and what was found there.
struct points read_points(const char *name, struct columns columns);
//<
