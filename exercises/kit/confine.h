// Confines the process that runs a student's code, or compiles it, and
// ends whatever that process leaves behind.
//
// Everywhere: limits of time, memory, output and threads, a session of
// its own, few descriptors; if we are root, the process is nobody's.
// Linux (x86-64, arm64): it may compute, allocate, start threads, print
// and sleep, and nothing else: no files, no processes, no signals to
// others, no network. Elsewhere the limits are all there is.
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

enum { KEEP_MAX = 3 };
struct limits {
    double seconds;
    size_t printed, memory; // bytes
    int keep[KEEP_MAX];     // descriptors that stay open, besides the
                            // standard ones; or -1
};

// In the judge: nobody may look into its memory, and processes that
// lose their parent become its children.
void guard_judge(void);

// In the student's process: everything but this, that it may still open
// files to read, so that its library can be loaded: those within this
// fence of fence.h, which is among the descriptors to keep.
void confine(struct limits limits, int fence);

// In the process of a compiler or the like: the limits and the fence
// around a folder, in which it may write, and no rules. The time is by
// the clock, and a signal ends it.
void confine_tool(struct limits limits, int file, const char *place);

// If we are root: this folder becomes nobody's.
void give_place(const char *place);

// In the student's process, afterward: not even that.
void confine_to_computing(void);

// Whether the rules, too, can be had here, or only the limits.
bool has_rules(void);

// In the judge: ends this child and all that stems from it, and waits
// until they are gone.
void end_children(pid_t child);

// In the judge: what can be read from when this child has ended; or -1,
// where only asking again and again is left.
int end_of(pid_t child);
