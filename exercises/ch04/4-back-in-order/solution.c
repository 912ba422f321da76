// Cell order in place: every stranger is exchanged with one that stands
// in its own cell, until none is a stranger. Each exchange brings at
// least one point home and sends none away.
#include "common/fail.h"
#include "exercise.h"
#include <stdlib.h>
#include <string.h>

//- solution
static void find_starts(uint32_t n, uint32_t m, uint32_t *start)
{
    memset(start, 0, ((size_t)m + 1) * sizeof *start);
    for (uint32_t s = 0; s < n; s++)
        start[cell_of(s) + 1]++;
    for (uint32_t k = 0; k < m; k++)
        start[k + 1] += start[k];
}

//- starter
//- end
void back_in_order(uint32_t n, uint32_t m, uint32_t *start)
{
    //- solution
    find_starts(n, m, start);
    // In each cell, all before this slot are at home.
    uint32_t *home = allocate(m, sizeof *home);
    memcpy(home, start, m * sizeof *home);
    for (uint32_t k = 0; k < m; k++)
        for (uint32_t s = home[k]; s < start[k + 1]; s++)
            while (cell_of(s) != k) {
                uint32_t c = cell_of(s);
                while (cell_of(home[c]) == c)
                    home[c]++;
                exchange(s, home[c]++);
            }
    free(home);
    //- starter
    // // Your turn: this moves no point, and starts are not set.
    // for (uint32_t k = 0; k <= m; k++)
    //     start[k] = n;
    //- end
}
