//> Declare the batch search for the furthest
// With wraparound: the driver of chapter 9 with the kernels for the
// furthest, alone or together with the nearest. What a kernel cannot
// certify is compared with a wider block, and then searched for from
// outside.
#pragma once
#include "ch09-row-spans/row_spans.h"

// Only with wraparound; threads and space are the question's. The
// points were partitioned with RESTORE and may have any number in a
// cell. A half whose arrays in answers are NULL is left out. What it
// needs besides is taken from the workspace and given back.
void search_near_and_far_batches(const struct question *question,
                                 const struct partition *partition,
                                 struct workspace *workspace,
                                 struct answers *answers);
//<
