//> Declare the manners of asking
// The search of row_spans.h on one thread, in each instruction set.
#pragma once
#include "ch04-cell-sort/sorted.h"

// Eight points together; each alone, in every row of its block; alone,
// and only in those rows that can have somebody near.
enum manner { TOGETHER, ALONE, SKIPPING };

// Answers for the sorted points begin .. end - 1, begin < end: the
// first of them at nearest[0] and nearest2[0].
typedef void span_search(const struct question *question,
                         const struct sorted *sorted,
                         enum manner manner, uint32_t begin,
                         uint32_t end, struct answers *found);
//<
