// NumPy's files of one array, .npy: a head that says what the array
// holds, then the numbers as they are in memory. Format versions 1, 2
// and 3.
#pragma once
#include "common/point_line.h"
#include "common/points.h"
#include "common/stream.h"

// Whether the stream begins as such a file does.
bool is_npy(struct stream *stream);

// The points of an array of doubles with n rows and two columns, or
// more columns of which two are named, in C's order or Fortran's. Fails
// where the file holds anything else, more, or less.
struct points read_npy(struct stream *stream, struct columns columns);
