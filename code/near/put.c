// Puts the parts of a row, and NumPy's head of all rows, one behind the
// other into memory that the caller has: a few steps a byte.
#include "near/put.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

char *put_bytes(char *to, const void *bytes, size_t count)
{
    return (char *)memcpy(to, bytes, count) + count;
}

char *put_text(char *to, const char *text)
{
    return put_bytes(to, text, strlen(text));
}

char *put_count(char *to, uint32_t count)
{
    char digits[10];
    int first = sizeof digits;
    do
        digits[--first] = (char)('0' + count % 10);
    while (count /= 10);
    return put_bytes(to, digits + first, sizeof digits - first);
}

char *put_names(char *to, const struct put_column *columns, int count)
{
    for (int k = 0; k < count; k++) {
        to = put_text(to, k > 0 ? "\t" : "");
        to = put_text(to, columns[k].name);
    }
    return put_text(to, "\n");
}

char *put_npy_head(char *to, const struct put_column *columns,
                   int count, uint64_t rows)
{
    enum { MAGIC = 10 };
    char *const head = to;
    to = put_text(to + MAGIC, "{'descr': [");
    for (int k = 0; k < count; k++)
        to += sprintf(to, "('%s', '%s'), ", columns[k].name,
                      columns[k].type);
    to += sprintf(
        to, "], 'fortran_order': False, 'shape': (%" PRIu64 ",), }",
        rows);
    while ((to - head) % 64 != 63)
        *to++ = ' ';
    *to++ = '\n';
    const uint16_t length = (uint16_t)(to - head - MAGIC);
    memcpy(head, "\x93NUMPY\1", 8);
    memcpy(head + 8, &length, sizeof length);
    return to;
}
