// Exercise: a promise kept
#pragma once
#include <stddef.h>

// Given. So many bytes that nothing has touched: all of them are 0, and
// the system has a page for them when they are touched. They begin
// where a page begins, and cannot be given back. MOST bytes can be had,
// in one call or in several.
enum { MOST = 64 << 20 };
void *fresh(size_t bytes);

// An array of so many bytes on top of the stack, at an address that is
// a multiple of 64. It stays where it is. What is in it does not matter
// to take; take_cleared makes it all 0.
void *take(size_t bytes);
void *take_cleared(size_t bytes);

// How high the stack is; and back to such a height: what was taken
// since is given up, and its memory is for the arrays to come.
size_t height(void);
void back_to(size_t height);
