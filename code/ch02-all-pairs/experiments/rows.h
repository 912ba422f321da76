// Times a rows_function on the rows begin .. end-1 of a question: the
// context of run_rows is a struct run.
#pragma once
#include "ch02-all-pairs/pair.h"

struct run {
    rows_function *rows;
    const struct question *question;
    struct answers *answers;
    uint32_t begin, end;
};

void run_rows(void *context);
