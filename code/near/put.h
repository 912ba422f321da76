// Pieces of a table of answers: each is written where the pointer says,
// and returns where the next one belongs.
#pragma once
#include <stddef.h>
#include <stdint.h>

char *put_text(char *to, const char *text);
char *put_count(char *to, uint32_t count);
char *put_bytes(char *to, const void *bytes, size_t count);

struct put_column {
    const char *name, *type; // in NumPy's words
};

// The names of the columns, with tabs between them, as a line.
char *put_names(char *to, const struct put_column *columns, int count);

// The head of an .npy file of records, see common/read_npy.h: filled
// with spaces, so that the numbers begin at a multiple of 64.
char *put_npy_head(char *to, const struct put_column *columns,
                   int count, uint64_t rows);
