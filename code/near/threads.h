// The threads that near works with: how many are worth it, and how they
// wait for each other.
#pragma once
#include <stdint.h>

enum { MAX_THREADS = 1024 }; // that can be asked for

// Starts the program once more, with threads that look for work only a
// moment, and then sleep: those that look all the time take it from
// other programs, and from each other, and to sleep and wake takes
// longer than many a wait. The OpenMP library reads what it is to do
// before main begins. Returns where that is settled already, or cannot
// be had. To be called first.
void reexec_with_passive_wait(char **argv);

// How many to use for n points, at least one, if so many are wanted, or
// 0 if that was left open. Fails where the system does not start them.
// To be asked before threads work, and after that for no more points.
int threads_for(int wanted, uint64_t n);
