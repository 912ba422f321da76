//> Declare the steps of the ladder
// From the coursework's loop to the last version, one change a step.
// All give bitwise the same answers.
#pragma once
#include "ch02-all-pairs/pair.h"

rows_function inlined_rows, split_rows, blocks_rows, lanes_rows;

struct step {
    const char *name;
    rows_function *rows;
};

extern const struct step steps[];
extern const int step_count;
//<
