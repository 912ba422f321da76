// A strip of tasks takes each step together, so that many loads are
// under way at a time. A task that has arrived is packed away.
#include "exercise.h"

//- solution
enum { STRIP = 64 };

// The tasks first to end - 1, at most a strip of them.
static void walk_strip(uint32_t first, uint32_t end, uint32_t *place,
                       const uint32_t *steps, const uint32_t *next)
{
    uint32_t task[STRIP], at[STRIP], left[STRIP], lanes = 0;
    for (uint32_t t = first; t < end; t++) {
        task[lanes] = t;
        at[lanes] = place[t];
        left[lanes] = steps[t];
        lanes += steps[t] > 0;
    }
    while (lanes > 0) {
        uint32_t kept = 0;
        for (uint32_t l = 0; l < lanes; l++) {
            const uint32_t here = next[at[l]], rest = left[l] - 1;
            place[task[l]] = here;
            task[kept] = task[l];
            at[kept] = here;
            left[kept] = rest;
            kept += rest > 0;
        }
        lanes = kept;
    }
}

//- starter
//- end
void walk(uint32_t tasks, uint32_t *place, const uint32_t *steps,
          const uint32_t *next)
{
    //- solution
    for (uint32_t t = 0; t < tasks; t += STRIP) {
        const uint32_t end = tasks - t < STRIP ? tasks : t + STRIP;
        walk_strip(t, end, place, steps, next);
    }
    //- starter
    // // Your turn: so far each task takes a single step.
    // for (uint32_t t = 0; t < tasks; t++)
    //     if (steps[t] > 0)
    //         place[t] = next[place[t]];
    //- end
}
