// Finds out what kind of file this is, and what its first lines say of
// all others. Nothing is guessed: each line is as the first, or it is
// refused where it stands.
#include "common/read_points.h"
#include "common/collect.h"
#include "common/fail.h"
#include "common/fields.h"
#include "common/read_npy.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

// The lines of a table whose first line is the current one.
static struct line_format table_format(const struct lines *lines,
                                       struct columns columns)
{
    struct line_format format = {
        .columns = columns,
        .separator = separator_of(lines->line),
        .expected = "numbers in the two columns",
        .fields_first = true,
    };
    format.fields = count_fields(lines->line, format.separator);
    snprintf(format.expected_fields, sizeof format.expected_fields,
             "%d field%s, as in line %zu", format.fields,
             format.fields > 1 ? "s" : "", lines->number);
    if (columns.x)
        return format;
    format.columns = (struct columns){1, 2};
    format.expected = format.fields > 2
                          ? "two numbers (or --columns I,J)"
                          : "two numbers";
    format.fields = 2;
    format.fields_first = false;
    strcpy(format.expected_fields, "two columns (or --columns I,J)");
    return format;
}

// The current line is its first. Each has as many fields as that one,
// or the columns are not what they seem.
static void read_table(struct collector *collector,
                       struct columns columns)
{
    struct lines *lines = &collector->lines;
    const struct line_format format = table_format(lines, columns);
    const char separator = format.separator;
    const struct columns c = format.columns;
    lines->tabs = separator == '\t';
    if (!lines->tabs)
        blank_tabs(lines);
    if (!is_word(find_field(lines->line, separator, c.x), separator) ||
        !is_word(find_field(lines->line, separator, c.y), separator))
        collect_line(collector, &format);
    collect_lines(collector, &format);
}

static bool is_tsplib(const char *line)
{
    static const char *const keywords[] = {"NAME",
                                           "TYPE",
                                           "COMMENT",
                                           "DIMENSION",
                                           "CAPACITY",
                                           "EDGE_WEIGHT_TYPE",
                                           "EDGE_WEIGHT_FORMAT",
                                           "EDGE_DATA_FORMAT",
                                           "NODE_COORD_TYPE",
                                           "DISPLAY_DATA_TYPE",
                                           "NODE_COORD_SECTION"};
    for (size_t k = 0; k < sizeof keywords / sizeof *keywords; k++) {
        size_t length = strlen(keywords[k]);
        if (is_keyword(line, keywords[k]) &&
            (line[length + strspn(line + length, " \t")] == ':' ||
             strcmp(keywords[k], "NODE_COORD_SECTION") == 0))
            return true;
    }
    return false;
}

// What stands behind the colon, or NULL.
static const char *value_of(const char *line)
{
    const char *value = strchr(line, ':');
    return value ? value + 1 + strspn(value + 1, " ") : NULL;
}

// The lines before the coordinates; returns the DIMENSION. Places on
// the globe have two coordinates as well, but not in a plane.
static double read_head(struct lines *lines)
{
    double dimension = -1;
    while (!is_keyword(lines->line, "NODE_COORD_SECTION")) {
        const char *value = value_of(lines->line);
        if (is_keyword(lines->line, "DIMENSION") &&
            !(value && read_number(value, 0, &dimension) &&
              is_count(dimension)))
            reject(lines, "the number of points");
        if (is_keyword(lines->line, "EDGE_WEIGHT_TYPE") && value &&
            strncmp(value, "GEO", 3) == 0)
            reject(lines, "points in a plane");
        if (!next_line(lines))
            fail("%s: expected a NODE_COORD_SECTION, found none",
                 lines->stream->name);
    }
    if (dimension < 0)
        fail("%s: expected a DIMENSION, found none",
             lines->stream->name);
    return dimension;
}

static void read_tsplib(struct collector *collector,
                        struct columns columns)
{
    struct lines *lines = &collector->lines;
    struct line_format format = {.columns = columns,
                                 .separator = ' ',
                                 .ended_by_word = true,
                                 .expected =
                                     "numbers in the two columns"};
    lines->tabs = false;
    blank_tabs(lines);
    if (!columns.x) {
        format.columns = (struct columns){2, 3};
        format.numbered = true;
        format.expected = "a point's number and its two coordinates";
        format.fields = 3;
        strcpy(format.expected_fields, format.expected);
    }
    double dimension = read_head(lines);
    bool ended = collect_lines(collector, &format);
    uint32_t n = collector->points.n;
    if (n != dimension || !(ended || lines->complete))
        fail("%s:%zu: expected %.0f points, as DIMENSION says, found "
             "%" PRIu32 "%s",
             lines->stream->name, lines->number, dimension, n,
             n == dimension ? ", the last cut short" : "");
}

static struct points read_text(struct stream *stream,
                               struct columns columns, int threads)
{
    struct collector collector = collector_of(stream, threads);
    struct lines *lines = &collector.lines;
    lines->tabs = true; // until we know what they mean
    if (next_line(lines)) {
        if (is_tsplib(lines->line))
            read_tsplib(&collector, columns);
        else
            read_table(&collector, columns);
    }
    collector_free(&collector);
    return collector.points;
}

struct points read_points(const char *name, struct columns columns,
                          int threads)
{
    struct stream stream = stream_open(name);
    const uint64_t stretches = stream_size(&stream) / STRETCH + 1;
    threads = stretches < (uint64_t)threads ? (int)stretches : threads;
    stream_reserve(&stream, LONGEST_LINE + (size_t)threads * STRETCH);
    struct points points = is_npy(&stream)
                               ? read_npy(&stream, columns)
                               : read_text(&stream, columns, threads);
    if (points.n == 0)
        fail("%s: expected points, found none", stream.name);
    stream_close(&stream);
    return points;
}
