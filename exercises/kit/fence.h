// A fence around what a process may open. Linux 5.13 and later, by
// Landlock; no rights are needed to build one.
#pragma once
#include <stdbool.h>

// Whether there can be one here.
bool can_fence(void);

// Builds one, for this process and those that it forks: a descriptor,
// or -1 where there can be none. Inside is what compilers and programs
// need of the system (libraries, headers, tools), the file `own` if it
// is not -1, and below `place`, if it is not NULL, where they may
// write, too. With `self` it is for this process alone, which may then
// look at itself, as sanitizers do: /proc/self is another folder for
// each.
int build_fence(int own, const char *place, bool self);

// From now on this process and its children can open nothing but what
// is inside. What is open already stays open, but for the fence itself.
// Does nothing for -1.
void enter_fence(int fence);
