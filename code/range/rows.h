// A file of numbers, row by row: points, places or boxes. Fields are
// separated as in files of points (common/read_points.h), the first
// line may be a header of words, and all lines have as many fields as
// the first one.
#pragma once
#include <stdint.h>

struct rows {
    uint32_t count;
    int columns;
    double *value; // value[row * columns + column]
};

// The rows of the file of this name, or of standard input for "-": at
// least one, all numbers finite. The first row has at most max
// numbers, or just as many as are wanted, if that is not 0. Released
// with free(rows.value). Fails with the name of the file, the line, and
// what was found there.
struct rows read_rows(const char *name, int wanted, int max);
