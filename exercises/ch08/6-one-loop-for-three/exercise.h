// Exercise: one loop for three
#pragma once
#include <stdint.h>

enum { STRIP = 256 }; // never more tasks than that
#define NOWHERE UINT32_MAX

// Given: cell[l] becomes the cell to which task[l] goes after the first
// visited[l] cells of its way, NOWHERE if it has finished. It depends
// on what the task has measured in those. Costs 1 for each lane.
void next_cell(uint32_t lanes, const uint32_t *task,
               const uint32_t *visited, uint32_t *cell);

// Given: lane l measures how far the point of task[l] is from the one
// at place[l], and keeps the nearest. Costs 1 for each lane.
void measure(uint32_t lanes, const uint32_t *task,
             const uint32_t *place);

// Lets the tasks 0 to n-1 measure all points of all cells on their
// ways, once each. Cell k has the places from start[k] up to, not
// including, start[k + 1].
void seek(uint32_t n, const uint32_t *start);
