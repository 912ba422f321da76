// The answers as a table, and whether they are right.
#pragma once
#include "range/answer.h"

// Writes the head of the table, and a row for each point found, or with
// --counts for each query, to the file that is open (near/write.h).
void write_head(const struct task *task);
void write_answers(const struct task *task, uint32_t first,
                   const struct answer *answer, uint32_t count);

// How many answers are not those of a loop over all points that shares
// nothing with the structures.
uint32_t count_wrong(const struct task *task, uint32_t first,
                     const struct answer *answer, uint32_t count);
