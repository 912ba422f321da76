// The answers as a table, written so that the file is whole or not
// there: into a file beside it, which takes its name at the end. What
// is no ordinary file, such as a pipe, is written to as it is.
#pragma once
#include "common/question.h"

// Opens early, so that an unwritable file is known before hours of
// work. "-" is standard output. Fails with a sentence.
void write_open(const char *name);

// One line a point, in full precision; columns whose array is NULL are
// left out. Then closes the file and gives it its name.
void write_answers(struct points points, const struct answers *answers);

// Leaves nothing half written behind. May be called at any time.
void write_abandon(void);
