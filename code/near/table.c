// A piece of rows at a time, each formatted by a thread and written
// when its turn has come, while others are formatted.
#include "near/table.h"
#include "algorithms.h"
#include "common/allocate.h"
#include "common/numbers.h"
#include "near/progress.h"
#include "near/put.h"
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

// The columns that there are answers for.
enum { MOST_COLUMNS = 7 };

static int columns_of(const struct table *table,
                      struct put_column columns[MOST_COLUMNS])
{
    static const struct put_column all[MOST_COLUMNS] = {
        {"i", "<u4"},
        {"x", "<f8"},
        {"y", "<f8"},
        {"nearest", "<u4"},
        {"nearest_distance", "<f8"},
        {"furthest", "<u4"},
        {"furthest_distance", "<f8"}};
    int count = 0;
    for (int k = 0; k < MOST_COLUMNS; k++)
        if (k < 3 || (k < 5 ? table->answers->nearest
                            : table->answers->furthest))
            columns[count++] = all[k];
    return count;
}

static char *put_line_of_names(char *to, const struct table *table)
{
    struct put_column columns[MOST_COLUMNS];
    return put_names(to, columns, columns_of(table, columns));
}

static char *put_head(char *to, const struct table *table)
{
    struct put_column columns[MOST_COLUMNS];
    const int count = columns_of(table, columns);
    return put_npy_head(to, columns, count, table->points.n);
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
    } kinds[] = {[TEXT_TABLE] = {put_line_of_names, put_line},
                 [NPY_TABLE] = {put_head, put_record}};
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
