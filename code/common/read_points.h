// Points from a file: a text that is a table of numbers or TSPLIB, or
// an array of NumPy's.
//
// A table has a point a line, its fields separated by semicolons, or
// else by commas, or else by single tabs, or else by spaces, however
// many: by what the first line has. What follows a '#' is a comment,
// what stands in double quotes separates nothing, empty lines do not
// count, and the first line may be a header of words. A table of more
// than two columns needs to be told which two, and all its lines have
// as many fields as the first. TSPLIB files are known by the keyword of
// their first line; their NODE_COORD_SECTION must hold as many points
// as DIMENSION says. For .npy files see read_npy.h.
#pragma once
#include "common/point_line.h"
#include "common/points.h"

// The points of the file of this name, or of standard input for "-": at
// least one, all coordinates finite, and 0 only where 0 is written. So
// many threads read a file, or fewer; the points are the same. The
// caller releases them with points_free. Fails with the name of the
// file, the line, and what was found there.
struct points read_points(const char *name, struct columns columns,
                          int threads);
