// One pass over the lines, a point a line, into arrays that double when
// they are full. Nothing is guessed: each line is as the first, or it
// is refused where it stands.
#include "common/read_points.h"
#include "common/allocate.h"
#include "common/fail.h"
#include "common/fields.h"
#include "common/lines.h"
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>
struct format {
    struct columns columns; // of x and y
    char separator;
    int width;            // fields in a line; 0: any number
    bool numbered;        // the first field is the point's number
    const char *expected; // in a line
};

struct reader {
    struct lines lines;
    struct points points; // read so far
    uint32_t capacity;    // of their arrays
};
static void grow(struct reader *reader)
{
    struct points *points = &reader->points;
    uint32_t capacity = points->n < (UINT32_MAX - 1000) / 2
                            ? 2 * points->n + 1000
                            : UINT32_MAX;
    struct points larger = points_allocate(capacity);
    if (points->n > 0) {
        memcpy(larger.x, points->x, points->n * sizeof(double));
        memcpy(larger.y, points->y, points->n * sizeof(double));
    }
    larger.n = points->n;
    points_free(points);
    *points = larger;
    reader->capacity = capacity;
}

static void add_point(struct reader *reader, double x, double y)
{
    struct points *points = &reader->points;
    if (points->n == UINT32_MAX)
        fail("%s:%zu: expected at most %" PRIu32 " points, found more",
             reader->lines.name, reader->lines.number, UINT32_MAX);
    if (points->n == reader->capacity)
        grow(reader);
    points->x[points->n] = x;
    points->y[points->n++] = y;
}
static void take_point(struct reader *reader,
                       const struct format *format)
{
    const struct lines *lines = &reader->lines;
    const char *line = lines->line;
    const char separator = format->separator;
    const char *field_x =
        find_field(line, separator, format->columns.x);
    const char *field_y =
        find_field(line, separator, format->columns.y);
    double x, y, number = 1;
    if (!read_number(field_x, separator, &x) ||
        !read_number(field_y, separator, &y) ||
        (format->numbered && !read_number(line, separator, &number)) ||
        !is_count(number))
        reject(lines, format->expected);
    if (!isfinite(x) || !isfinite(y))
        reject(lines, "finite numbers");
    if (has_vanished(field_x, x) || has_vanished(field_y, y))
        reject(lines, "numbers that a double can tell from 0");
    if (format->width && count_fields(line, separator) != format->width)
        reject(lines, format->width == 2
                          ? "two columns (or --columns I,J)"
                          : format->expected);
    add_point(reader, x, y);
}
// Each line has as many fields as the first one, or the columns are not
// what they seem.
static void take_points_as(struct reader *reader, struct format *format,
                           int fields, size_t first)
{
    struct lines *lines = &reader->lines;
    do {
        if (count_fields(lines->line, format->separator) != fields) {
            char expected[80];
            snprintf(expected, sizeof expected,
                     "%d field%s, as in line %zu", fields,
                     fields > 1 ? "s" : "", first);
            reject(lines, expected);
        }
        take_point(reader, format);
    } while (next_line(lines));
}
// The current line is its first.
static void read_table(struct reader *reader, struct columns columns)
{
    struct lines *lines = &reader->lines;
    const char separator = separator_of(lines->line);
    const int fields = count_fields(lines->line, separator);
    const size_t first = lines->number;
    struct format format = {columns, separator, 0, false,
                            "numbers in the two columns"};
    lines->tabs = separator == '\t';
    if (!lines->tabs)
        blank_tabs(lines);
    if (!columns.x) {
        format.columns = (struct columns){1, 2};
        format.width = 2;
        format.expected = fields > 2 ? "two numbers (or --columns I,J)"
                                     : "two numbers";
    }
    const struct columns c = format.columns;
    if (is_word(find_field(lines->line, separator, c.x), separator) &&
        is_word(find_field(lines->line, separator, c.y), separator) &&
        !next_line(lines))
        return;
    if (columns.x) {
        take_points_as(reader, &format, fields, first);
        return;
    }
    do
        take_point(reader, &format);
    while (next_line(lines));
}
static bool is_keyword(const char *line, const char *keyword)
{
    size_t length = strlen(keyword);
    return strncmp(line, keyword, length) == 0 &&
           strchr(" \t:", line[length]);
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
            !(read_number(value, 0, &dimension) && is_count(dimension)))
            reject(lines, "the number of points");
        if (is_keyword(lines->line, "EDGE_WEIGHT_TYPE") && value &&
            strncmp(value, "GEO", 3) == 0)
            reject(lines, "points in a plane");
        if (!next_line(lines))
            fail("%s: expected a NODE_COORD_SECTION, found none",
                 lines->name);
    }
    if (dimension < 0)
        fail("%s: expected a DIMENSION, found none", lines->name);
    return dimension;
}

static void read_tsplib(struct reader *reader, struct columns columns)
{
    struct lines *lines = &reader->lines;
    struct format format = {columns, ' ', 0, false,
                            "numbers in the two columns"};
    lines->tabs = false;
    blank_tabs(lines);
    if (!columns.x)
        format =
            (struct format){{2, 3},
                            ' ',
                            3,
                            true,
                            "a point's number and its two coordinates"};
    double dimension = read_head(lines);
    bool ended = false;
    while (!ended && next_line(lines))
        if (is_keyword(lines->line, "EOF") ||
            strcmp(lines->line, "-1") == 0 ||
            strstr(lines->line, "_SECTION"))
            ended = true;
        else
            take_point(reader, &format);
    if (reader->points.n != dimension || !(ended || lines->complete))
        fail("%s:%zu: expected %.0f points, as DIMENSION says, found "
             "%" PRIu32 "%s",
             lines->name, lines->number, dimension, reader->points.n,
             reader->points.n == dimension ? ", the last cut short"
                                           : "");
}
struct points read_points(const char *name, struct columns columns)
{
    struct reader reader = {.lines = lines_open(name)};
    struct lines *lines = &reader.lines;
    lines->tabs = true; // until we know what they mean
    if (next_line(lines)) {
        if (is_tsplib(lines->line))
            read_tsplib(&reader, columns);
        else
            read_table(&reader, columns);
    }
    if (reader.points.n == 0)
        fail("%s: expected points, found none", lines->name);
    lines_close(lines);
    return reader.points;
}
