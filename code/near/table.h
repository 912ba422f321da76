// All answers, as a table: a line of text for each point, or a record
// of NumPy's.
#pragma once
#include "common/question.h"
#include <stdbool.h>

enum table_kind { TEXT_TABLE, NPY_TABLE };

// What a table in a file of this name is.
enum table_kind table_kind(const char *name);

// Writes a row for each point of the question, in order, to the file
// that is open (see write.h); columns whose array is NULL are left out.
// The question's threads format it; the bytes are the same.
void write_table(enum table_kind kind, const struct question *question,
                 const struct answers *answers);
