// Lists of neighbors as a table, and the plain search that judges them.
#pragma once
#include "ch12-range-queries/plane_neighbors.h"
#include "near/table.h"

// The head of the table, with so many rows: i neighbor distance; or for
// counts i count.
void write_lists_head(enum table_kind kind, bool counts, uint64_t rows);

// A row for each neighbor, in order, by so many threads; or for each
// of n counts.
void write_lists(enum table_kind kind,
                 const struct neighbor_lists *lists, int threads);
void write_counts(enum table_kind kind, const uint32_t *count,
                  uint32_t n);

// How many lists are wrong, and the first of them is noted: a list is
// right if its distances are true, in order, equal ones by index, if no
// other point would come before its last, and if it is as long as it
// must be. Looks at every pair. If reach2 is INFINITY, a list must be
// as long as it is.
uint32_t check_lists(const struct question *question, double reach2,
                     const struct neighbor_lists *lists,
                     uint32_t *first_wrong);
uint32_t check_counts(const struct question *question, double reach2,
                      const uint32_t *count, uint32_t *first_wrong);
