// Slow motion: makes data races happen.
//
// An unguarded update is lost only if two threads meet within a few
// nanoseconds, which may take years. The library of an exercise whose
// tests.c includes this header is compiled so that every access to
// memory that threads could share calls a hook (the compiler does this
// for -fsanitize=thread; the hooks here take that tool's place). While
// the motion is slow, a thread falls asleep before it writes, plainly
// or atomically. What it read is then old, other threads have gone on,
// and a lost update is the rule, even on a single core. Not in the
// sanitized variant.
#pragma once
#include <stdbool.h>

// Called in the student's process, around the student's function.
void slow_motion(bool on);
