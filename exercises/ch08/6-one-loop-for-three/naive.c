// Nested loops, as in figure 8: all tasks wait for the fullest cell.
// expect: 4 of 10
#include "exercise.h"

void seek(uint32_t n, const uint32_t *start)
{
    uint32_t task[STRIP], visited[STRIP], cell[STRIP];
    for (uint32_t l = 0; l < n; l++) {
        task[l] = l;
        visited[l] = 0;
    }
    while (n > 0) {
        next_cell(n, task, visited, cell);
        uint32_t left = 0;
        for (uint32_t l = 0; l < n; l++)
            if (cell[l] != NOWHERE) {
                task[left] = task[l];
                visited[left] = visited[l] + 1;
                cell[left++] = cell[l];
            }
        n = left;
        for (uint32_t b = 0, busy = 1; busy > 0; b++) {
            uint32_t who[STRIP], place[STRIP];
            busy = 0;
            for (uint32_t l = 0; l < n; l++)
                if (start[cell[l]] + b < start[cell[l] + 1]) {
                    who[busy] = task[l];
                    place[busy++] = start[cell[l]] + b;
                }
            if (busy > 0)
                measure(busy, who, place);
        }
    }
}
