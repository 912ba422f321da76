// Confines the process that runs a student's code, and ends whatever
// that process leaves behind.
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

struct limits {
    double seconds;
    size_t printed, memory; // bytes
    int keep[2];            // descriptors that stay open, besides the
                            // standard ones
};

// In the judge: nobody may look into its memory, and processes that
// lose their parent become its children.
void guard_judge(void);

// In the student's process: everything but this, that it may still open
// files to read, so that its library can be loaded.
void confine(struct limits limits);

// In the student's process, afterward: not even that.
void confine_to_computing(void);

// Whether the rules, too, can be had here, or only the limits.
bool has_rules(void);

// In the judge: ends this child and all that stems from it, and waits
// until they are gone.
void end_children(pid_t child);
