//> Declare the search by cells with threads
// All nearest neighbors: points partitioned into cells, then chapter
// 4's batches of four, every step by all threads.
#pragma once
#include "common/question.h"

search_function cells_threads; // the row of the table
//<
