// Exercise: while one waits
#pragma once
#include <stdint.h>

// Task t stands at place[t], and goes steps[t] steps. A step leads from
// place p to next[p]. Sets place[t] to where task t arrives. There may
// be no tasks, and tasks without a step.
void walk(uint32_t tasks, uint32_t *place, const uint32_t *steps,
          const uint32_t *next);
