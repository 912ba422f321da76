//> Declare the search by row spans
// The nearest neighbors of points that are sorted by cell. Eight points
// that follow each other in a row of cells ask together. The cells
// around them are a span of the sorted points in each of three rows,
// which are copied to a small table in single precision; a sweep over
// it finds out for each of the eight who is nearest and whether, with
// all rounding, nobody else can be. His distance is then computed in
// double precision. Those for whom that does not settle it ask alone.
// About 9 c + 22 distances a point, c points in a cell; threads share
// out the points.
#pragma once
#include "ch09-row-spans/carry.h"
#include "ch09-row-spans/manners.h"

// Where this search is fastest on average.
#define POINTS_PER_SPAN_CELL 1.5

// Nearest only; threads and space are the question's, the instruction
// set is isa_chosen(). The points, which were carried, may have any
// number in a cell. The answers go back as the points came.
void search_row_spans(const struct question *question,
                      const struct carried *carried, enum manner manner,
                      struct answers *answers);

// Its counting twin: take the counts with counting_take.
void counting_search_row_spans(const struct question *question,
                               const struct carried *carried,
                               enum manner manner,
                               struct answers *answers);

// Together, for points that may be sorted in any way, in turns of at
// most LONGEST_TURN: so many answers are kept before they are taken
// straight to their places.
enum { LONGEST_TURN = 1024 };
void search_in_turns(const struct question *question,
                     const struct sorted *sorted, uint32_t length,
                     struct answers *answers);

// Together, with a visit to every tile, which finds the furthest. A
// half whose arrays are NULL is not sent back.
void search_and_visit(const struct question *question,
                      const struct carried *carried,
                      const struct visit *visit,
                      struct answers *answers);

// The row of the table: sorts, carrying the points, and searches.
void row_spans(const struct question *question,
               struct answers *answers);
//<
