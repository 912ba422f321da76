// A piece of rows at a time, each formatted by a thread and written
// when its turn has come, while others are formatted.
#include "near/table.h"
#include "algorithms.h"
#include "common/allocate.h"
#include "common/numbers.h"
#include "near/progress.h"
#include "near/write.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    PIECE = 4096,
    LONGEST_ROW = 3 * 11 + 4 * LONGEST_NUMBER,
    LONGEST_HEAD = 512
};

struct table {
    struct points points;
    const struct answers *answers;
};

static const struct column {
    const char *name, *type; // in NumPy's words
    unsigned answers;        // that it is for; 0: any
} columns[] = {
    {"i", "<u4", 0},
    {"x", "<f8", 0},
    {"y", "<f8", 0},
    {"nearest", "<u4", NEAREST},
    {"nearest_distance", "<f8", NEAREST},
    {"furthest", "<u4", FURTHEST},
    {"furthest_distance", "<f8", FURTHEST},
};
enum { COLUMNS = sizeof columns / sizeof *columns };

static bool has(const struct table *table, struct column column)
{
    return !(column.answers & NEAREST && !table->answers->nearest) &&
           !(column.answers & FURTHEST && !table->answers->furthest);
}

static char *put_text(char *to, const char *text)
{
    const size_t length = strlen(text);
    return (char *)memcpy(to, text, length) + length;
}

static char *put_names(char *to, const struct table *table)
{
    for (int k = 0; k < COLUMNS; k++)
        if (has(table, columns[k])) {
            to = put_text(to, k > 0 ? "\t" : "");
            to = put_text(to, columns[k].name);
        }
    return put_text(to, "\n");
}

static char *put_count(char *to, uint32_t count)
{
    char digits[10];
    int first = sizeof digits;
    do
        digits[--first] = (char)('0' + count % 10);
    while (count /= 10);
    memcpy(to, digits + first, sizeof digits - first);
    return to + sizeof digits - first;
}

static char *put_neighbor(char *to, uint32_t neighbor, double distance2)
{
    *to++ = '\t';
    to = put_count(to, neighbor);
    *to++ = '\t';
    return number_to_text(to, sqrt(distance2));
}

static char *put_line(char *to, const struct table *table, uint32_t i)
{
    const struct answers *a = table->answers;
    to = put_count(to, i);
    *to++ = '\t';
    to = number_to_text(to, table->points.x[i]);
    *to++ = '\t';
    to = number_to_text(to, table->points.y[i]);
    if (a->nearest)
        to = put_neighbor(to, a->nearest[i], a->nearest2[i]);
    if (a->furthest)
        to = put_neighbor(to, a->furthest[i], a->furthest2[i]);
    *to++ = '\n';
    return to;
}

// The head of an .npy file, see common/read_npy.h: filled with spaces,
// so that the numbers begin at a multiple of 64.
static char *put_npy_head(char *to, const struct table *table)
{
    enum { MAGIC = 10 };
    char *const head = to;
    to = put_text(to + MAGIC, "{'descr': [");
    for (int k = 0; k < COLUMNS; k++)
        if (has(table, columns[k]))
            to += sprintf(to, "('%s', '%s'), ", columns[k].name,
                          columns[k].type);
    to += sprintf(
        to, "], 'fortran_order': False, 'shape': (%" PRIu32 ",), }",
        table->points.n);
    while ((to - head) % 64 != 63)
        *to++ = ' ';
    *to++ = '\n';
    const uint16_t length = (uint16_t)(to - head - MAGIC);
    memcpy(head, "\x93NUMPY\1", 8);
    memcpy(head + 8, &length, sizeof length);
    return to;
}

static char *put_bytes(char *to, const void *bytes, size_t count)
{
    return (char *)memcpy(to, bytes, count) + count;
}

static char *put_pair(char *to, uint32_t neighbor, double distance2)
{
    const double distance = sqrt(distance2);
    to = put_bytes(to, &neighbor, sizeof neighbor);
    return put_bytes(to, &distance, sizeof distance);
}

static char *put_record(char *to, const struct table *table, uint32_t i)
{
    const struct answers *a = table->answers;
    to = put_bytes(to, &i, sizeof i);
    to = put_bytes(to, &table->points.x[i], sizeof(double));
    to = put_bytes(to, &table->points.y[i], sizeof(double));
    if (a->nearest)
        to = put_pair(to, a->nearest[i], a->nearest2[i]);
    if (a->furthest)
        to = put_pair(to, a->furthest[i], a->furthest2[i]);
    return to;
}

enum table_kind table_kind(const char *name)
{
    const size_t length = strlen(name);
    return length > 4 && strcmp(name + length - 4, ".npy") == 0
               ? NPY_TABLE
               : TEXT_TABLE;
}

void write_table(enum table_kind kind, const struct question *question,
                 const struct answers *answers)
{
    static const struct {
        char *(*put_head)(char *, const struct table *);
        char *(*put_row)(char *, const struct table *, uint32_t);
    } kinds[] = {[TEXT_TABLE] = {put_names, put_line},
                 [NPY_TABLE] = {put_npy_head, put_record}};
    const struct table table = {question->points, answers};
    const uint32_t n = question->points.n;
    char head[LONGEST_HEAD];
    write_bytes(head, kinds[kind].put_head(head, &table) - head);
    if (write_is_file())
        progress_start("writing", n);
#pragma omp parallel num_threads(question->threads)
    {
        char *rows = allocate(PIECE, LONGEST_ROW), *end;
#pragma omp for ordered schedule(dynamic)
        for (uint32_t first = 0; first < n; first += PIECE) {
            uint32_t last = n - first < PIECE ? n : first + PIECE;
            end = rows;
            for (uint32_t i = first; i < last; i++)
                end = kinds[kind].put_row(end, &table, i);
#pragma omp ordered
            write_bytes(rows, end - rows);
            progress_rows(last - first);
        }
        free(rows);
    }
    progress_stop();
}
