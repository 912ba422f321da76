// While the work is long and standard error is a terminal, a line there
// says what is going on and for how long. It costs the work nothing: a
// thread of its own writes it once a second.
#pragma once
#include <stdint.h>

// Starts to show what is done. If rows is not 0, the share of the rows
// that progress_rows has been told of is shown as well.
void progress_start(const char *what, uint32_t rows);
void progress_rows(uint32_t count); // more; called by any thread
void progress_stop(void);
