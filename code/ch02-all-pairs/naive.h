//> Declare the naive search
// All pairs, as plainly as they can be written: the answer that every
// other algorithm of the book is held to. n (n-1) distances, no memory
// of its own; threads share out the points.
#pragma once
#include "common/question.h"

// Nearest and furthest, both geometries.
search_function naive;
//<
