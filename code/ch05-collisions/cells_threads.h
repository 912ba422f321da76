//> Declare the search by cells with threads
// All nearest neighbors: points partitioned into cells, then chapter
// 4's batches of four, every step by all threads. The workspace is the
// question's, or a temporary one.
#pragma once
#include "common/question.h"

// The row of the table.
void cells_threads(const struct question *question,
                   struct answers *answers);
//<
