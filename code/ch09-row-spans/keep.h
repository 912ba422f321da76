//> Declare what keeps memory
// What a search gives back, the C library may give back to the system,
// and the next search has to get it again, page by page, and cleared.
// A program that searches often asks the library to keep it.
#pragma once

// From now on, memory that is freed stays with this program. A C
// library other than GNU's is not asked.
void memory_keep(void);
//<
