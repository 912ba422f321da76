//> Declare the triangular loop
// Nearest and furthest neighbors from half the pairs: every distance
// is measured once and offered to both of its ends. Ties go to the
// lowest index. Distances are squared.
#pragma once
#include "common/question.h"

// Before any distance is known, the neighbor of every point is the
// lowest other index, nearest at infinity and furthest at zero.
void triangle_begin(struct answers *answers, uint32_t n);

// Measures point i against the points after it and improves the
// answers of both ends. Rows must come by ascending i, though some may
// be missing: of equal distances the one that came first is kept.
void triangle_row(const struct question *question,
                  struct answers *answers, uint32_t i);

// All rows on one thread: n (n-1) / 2 distances, no memory of its own.
search_function triangle;
//<
