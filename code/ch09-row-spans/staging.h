//> Declare the staging buffer
// Copies the candidates of neighboring queries to a small buffer, three
// row spans in single precision. With wraparound, what is beyond the
// seam is staged one period away, where the queries see it.
#pragma once
#include "ch09-row-spans/batch.h"

// Before the first use of a buffer, which shall reach no further than
// that if it is for more than a batch.
void staging_prepare(struct staging *staging, double max_reach);

// Stages all candidates of the sorted points begin .. begin + width -
// 1, which are in this row of the grid. False if that cannot be: a row
// has more than STAGED - 2 * PAD of them, or the coordinates do not fit
// into single precision, or the block goes all the way round.
bool stage_candidates(const struct scene *scene, uint32_t row,
                      uint32_t begin, uint32_t width,
                      struct staging *staging);

// Finds the candidates of a batch, whose begin and width are set,
// as are the rows of its block.
void find_candidates(const struct scene *scene,
                     const struct staging *staging,
                     struct query_batch *batch);
//<
