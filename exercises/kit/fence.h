// A fence around what a process may open. Linux 5.13 and later, by
// Landlock; no rights are needed to build one.
#pragma once
#include <stdbool.h>

// Whether there can be one here.
bool can_fence(void);

// From now on this process and its children can open nothing but what
// compilers and programs need of the system (libraries, headers,
// tools), the file `own` if it is not -1, and below `place`, if it is
// not NULL, where they may write, too. What is open already stays open.
// Does nothing where there can be no fence.
void build_fence(int own, const char *place);
