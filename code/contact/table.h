// The table that contact writes, step by step.
#pragma once
#include "ch13-contact/step.h"

// A row for each step, or for each event of a step, to the file that is
// open (near/write.h).
void write_step_head(void);
void write_step(uint32_t step, const struct step_report *report);
void write_event_head(void);
void write_events(uint32_t step, const struct events *events);
