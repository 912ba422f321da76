// A file that is whole or not there: what is written goes into a file
// beside it, which takes its name at the end. What is no ordinary file,
// such as a pipe, is written to as it is.
#pragma once
#include <stdbool.h>
#include <stddef.h>

// Ends the program where standard output or error is closed. A file
// opened then would take its place, and get what was meant for it.
void insist_on_output(void);

// Opens early, so that an unwritable file is known before hours of
// work. "-" is standard output. Fails with a sentence.
void write_open(const char *name);
bool write_is_file(void);

// Adds to the file; called by one thread at a time. What goes wrong is
// said by write_close.
void write_bytes(const char *bytes, size_t count);

// Gives the file its name, once it is on the disk. Fails with a
// sentence if it could not be written.
void write_close(void);

// Leaves nothing half written behind. May be called at any time.
void write_abandon(void);
