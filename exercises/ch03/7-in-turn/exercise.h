// Exercise: in turn
#pragma once
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

// A lock in eight bytes; free if both numbers are equal. It may begin
// with any two equal numbers.
struct lock {
    _Atomic uint32_t next, serving;
};

// To be called between two looks at a lock that is taken. Given; it
// counts.
void pause_before_next_look(void);

// Waits until the lock is the caller's. Threads get it in the order in
// which they come.
void acquire(struct lock *lock);

// Gives it back. Called by the thread that has it.
void release(struct lock *lock);

// Takes the lock if it is free, and is true; otherwise changes nothing
// and is false. Does not wait.
bool try_acquire(struct lock *lock);
