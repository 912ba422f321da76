//> Declare what keeps memory
// What a search gives back, the C library may give back to the system,
// and the next search has to get it again, page by page, and cleared.
// A program that searches often asks the library to keep it.
#pragma once
#include <stdbool.h>

// Whether memory that is freed stays with this program, from now on.
// At first it does not. A C library other than GNU's is not asked.
void memory_keep(bool keep);
//<
