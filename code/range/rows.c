// One line after the other; room for the numbers doubles when it is
// full, so that a number is copied twice at most, on average.
#include "range/rows.h"
#include "common/fail.h"
#include "common/fields.h"
#include "common/lines.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct reader {
    struct lines lines;
    struct rows rows;
    uint64_t room; // for numbers
    char separator;
    char expected[64]; // in a line
};

static void expect_columns(struct reader *reader, int wanted, int max)
{
    const int found =
        count_fields(reader->lines.line, reader->separator);
    const int columns = wanted ? wanted : found;
    snprintf(reader->expected, sizeof reader->expected, "%d number%s",
             columns, columns > 1 ? "s" : "");
    if (!wanted && found > max)
        snprintf(reader->expected, sizeof reader->expected,
                 "1 to %d numbers", max);
    if (found != columns || found > max)
        reject(&reader->lines, reader->expected);
    reader->rows.columns = columns;
}

static bool is_header(const struct reader *reader)
{
    const char *field = reader->lines.line;
    for (; field; field = next_field(field, reader->separator))
        if (!is_word(field, reader->separator))
            return false;
    return true;
}

static double *next_row(struct reader *reader)
{
    struct rows *rows = &reader->rows;
    const uint64_t used = (uint64_t)rows->count * rows->columns;
    if (rows->count == UINT32_MAX)
        fail("%s: more than %u lines", reader->lines.stream->name,
             UINT32_MAX);
    if (used + rows->columns > reader->room) {
        reader->room = 2 * reader->room + 4096;
        double *more = allocate(reader->room, sizeof *more);
        if (used)
            memcpy(more, rows->value, used * sizeof *more);
        free(rows->value);
        rows->value = more;
    }
    rows->count++;
    return rows->value + used;
}

static void take_row(struct reader *reader)
{
    const char *field = reader->lines.line;
    const int columns = reader->rows.columns;
    if (count_fields(field, reader->separator) != columns)
        reject(&reader->lines, reader->expected);
    double *value = next_row(reader);
    for (int k = 0; k < columns; k++) {
        if (!read_number(field, reader->separator, &value[k]))
            reject(&reader->lines, reader->expected);
        if (!isfinite(value[k]))
            reject(&reader->lines, "finite numbers");
        field = next_field(field, reader->separator);
    }
}

struct rows read_rows(const char *name, int wanted, int max)
{
    struct stream stream = stream_open(name);
    stream_reserve(&stream, 2 * (size_t)LONGEST_LINE);
    struct reader reader = {.lines = lines_of(&stream)};
    reader.lines.tabs = true; // until we know what they mean
    bool more = next_line(&reader.lines);
    if (more) {
        reader.separator = separator_of(reader.lines.line);
        reader.lines.tabs = reader.separator == '\t';
        if (!reader.lines.tabs)
            blank_tabs(&reader.lines);
        expect_columns(&reader, wanted, max);
        if (is_header(&reader))
            more = next_line(&reader.lines);
    }
    for (; more; more = next_line(&reader.lines))
        take_row(&reader);
    if (reader.rows.count == 0)
        fail("%s: expected numbers, found none", stream.name);
    lines_free(&reader.lines);
    stream_close(&stream);
    return reader.rows;
}
