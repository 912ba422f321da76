// One task after the other, each to its end.
// expect: 4 of 10
#include "exercise.h"

void walk(uint32_t tasks, uint32_t *place, const uint32_t *steps,
          const uint32_t *next)
{
    for (uint32_t t = 0; t < tasks; t++)
        for (uint32_t s = 0; s < steps[t]; s++)
            place[t] = next[place[t]];
}
