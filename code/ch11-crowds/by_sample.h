//> Declare the choice
// One grid where the points are spread evenly enough, pieces where they
// crowd. A sample sees most crowds, for next to nothing; what it lets
// pass is counted, cell by cell, before anything is compared.
#pragma once
#include "common/question.h"

// The row of the table: near-and-far or adaptive; question->by says
// which.
search_function by_sample;
//<
