//> Read points from a file
// See read_points.h. One pass over the lines; every mistake is reported
// where it stands. Decimal points are points because no program of ours
// leaves the C locale.
#include "common/read_points.h"
#include "common/fail.h"
#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//> Remember where we are in the file
enum { LONGEST = 1 << 20 }; // line that was meant to be read

struct format {
    struct columns columns;
    int width;            // columns in a line, 0: any number
    bool numbered;        // the first column is the point's number
    const char *expected; // in a line
};

struct reader {
    const char *name; // of the file, for messages
    FILE *file;
    char *line;    // the current one, trimmed; room for LONGEST
    size_t number; // of the line, from 1
    bool complete; // the line ended in '\n'
    struct points points;
    uint32_t capacity;
};
//<

//> Say what is wrong with a line
static _Noreturn void reject(const struct reader *reader,
                             const char *expected)
{
    enum { most = 60 }; // a quotation, not the whole file
    fail("%s:%zu: expected %s, found \"%.*s\"%s", reader->name,
         reader->number, expected, most, reader->line,
         strlen(reader->line) > most ? "..." : "");
}
//<

//> Read the next line that says something
// Makes every tab a space. A control character is a sign that this was
// never meant to be read by people.
static bool make_plain(char *line, size_t length)
{
    for (char *c = line; c < line + length; c++)
        if (*c == '\t')
            *c = ' ';
        else if ((unsigned char)*c < ' ' && *c != '\n' &&
                 !(*c == '\r' && (c[1] == '\n' || c[1] == 0)))
            return false;
    return true;
}

// The length of the next line with its end; 0 at the end of the file.
// A null character ends it too: what follows one is no text.
static size_t read_line(struct reader *reader)
{
    size_t length = 0;
    int c = ' ';
    while (c && c != '\n' && length < LONGEST - 1 &&
           (c = getc_unlocked(reader->file)) != EOF)
        reader->line[length++] = (char)c;
    reader->line[length] = 0;
    return length;
}

// Cuts off a comment, and the spaces around what is left.
static void trim(char *line)
{
    char *start = line + strspn(line, " ");
    char *end = start + strcspn(start, "#");
    while (end > start && isspace((unsigned char)end[-1]))
        end--;
    memmove(line, start, end - start);
    line[end - start] = 0;
}

static bool next_line(struct reader *reader)
{
    do {
        size_t length = read_line(reader);
        if (ferror(reader->file))
            fail("cannot read %s: %s", reader->name, strerror(errno));
        if (length == 0)
            return false;
        reader->number++;
        if (length == LONGEST - 1)
            fail("%s:%zu: expected text, found a line without end",
                 reader->name, reader->number);
        reader->complete = reader->line[length - 1] == '\n';
        if (!make_plain(reader->line, length))
            fail("%s:%zu: expected text, found a binary file",
                 reader->name, reader->number);
        if (strncmp(reader->line, "\xef\xbb\xbf", 3) == 0)
            memset(reader->line, ' ', 3); // a byte order mark
        trim(reader->line);
    } while (!*reader->line);
    return true;
}
//<

//> Find a field in a line
static char separator_of(const char *line)
{
    return strchr(line, ';') ? ';' : strchr(line, ',') ? ',' : ' ';
}

// NULL if the line has fewer columns.
static const char *find_field(const char *line, int column)
{
    char separator = separator_of(line);
    while (--column > 0 && (line = strchr(line, separator)))
        line += 1 + strspn(line + 1, " ");
    return line;
}
//<

//> Read the number in a field
// Whether the field is a number and nothing else. It may be infinite or
// no number at all in the sense of IEEE 754, but not hexadecimal.
static bool read_number(const char *field, char separator,
                        double *number)
{
    char *end;
    if (!field ||
        tolower((unsigned char)field[strspn(field, "+-0")]) == 'x')
        return false;
    *number = strtod(field, &end);
    if (end == field)
        return false;
    if (separator != ' ')
        end += strspn(end, " ");
    return *end == 0 || *end == separator;
}
//<

//> Tell a count from other numbers
static bool is_count(double number)
{
    return number >= 1 && number <= UINT32_MAX &&
           number == floor(number);
}
//<

//> Add a point to those we have
static void add_point(struct reader *reader, double x, double y)
{
    struct points *points = &reader->points;
    if (points->n == UINT32_MAX)
        fail("%s:%zu: expected at most %" PRIu32 " points, found more",
             reader->name, reader->number, UINT32_MAX);
    if (points->n == reader->capacity) {
        uint32_t more = points->n < (UINT32_MAX - 1000) / 2
                            ? 2 * points->n + 1000
                            : UINT32_MAX;
        struct points larger = points_allocate(more);
        if (points->n > 0) {
            memcpy(larger.x, points->x, points->n * sizeof(double));
            memcpy(larger.y, points->y, points->n * sizeof(double));
        }
        larger.n = points->n;
        points_free(points);
        *points = larger;
        reader->capacity = more;
    }
    points->x[points->n] = x;
    points->y[points->n++] = y;
}
//<

//> Take the point of a line
static void take_point(struct reader *reader,
                       const struct format *format)
{
    const char *line = reader->line;
    char separator = separator_of(line);
    const char *field_x = find_field(line, format->columns.x);
    const char *field_y = find_field(line, format->columns.y);
    double x, y, number = 1;
    if (!read_number(field_x, separator, &x) ||
        !read_number(field_y, separator, &y) ||
        (format->numbered && !read_number(line, separator, &number)) ||
        !is_count(number))
        reject(reader, format->expected);
    if (!isfinite(x) || !isfinite(y))
        reject(reader, "finite numbers");
    if (format->width && find_field(line, format->width + 1))
        reject(reader, format->width == 2
                           ? "two columns (or --columns I,J)"
                           : format->expected);
    add_point(reader, x, y);
}
//<

//> Tell a header's word
// A missing value is not one, nor is a number in quotes.
static bool is_word(const char *field, char separator)
{
    static const char *const missing[] = {"NA", "N/A", "NULL"};
    if (!field)
        return false;
    if (*field == '"')
        field++, separator = '"';
    size_t length = strcspn(field, "\" ,;");
    for (int k = 0; k < 3; k++)
        if (length == strlen(missing[k]) &&
            strncmp(field, missing[k], length) == 0)
            return false;
    double number;
    return !read_number(field, separator, &number) &&
           (isalpha((unsigned char)*field) || *field == '_' ||
            (unsigned char)*field >= 0x80);
}
//<

//> Read a table

static void read_table(struct reader *reader, struct columns columns)
{
    struct format format = {columns, 0, false,
                            "numbers in the two columns"};
    char separator = separator_of(reader->line);
    if (!columns.x)
        format = (struct format){{1, 2},
                                 2,
                                 false,
                                 find_field(reader->line, 3)
                                     ? "two numbers (or --columns I,J)"
                                     : "two numbers"};
    columns = format.columns;
    bool header =
        is_word(find_field(reader->line, columns.x), separator) &&
        is_word(find_field(reader->line, columns.y), separator);
    if (header && !next_line(reader))
        return;
    do
        take_point(reader, &format);
    while (next_line(reader));
}
//<

//> Read a TSPLIB file
static bool is_keyword(const char *line, const char *keyword)
{
    size_t length = strlen(keyword);
    return strncmp(line, keyword, length) == 0 &&
           strchr(" :", line[length]);
}

static bool is_tsplib(const char *line)
{
    size_t length = strspn(line, "ABCDEFGHIJKLMNOPQRSTUVWXYZ_");
    return is_keyword(line, "NODE_COORD_SECTION") ||
           (length > 0 &&
            line[length + strspn(line + length, " ")] == ':');
}

// What stands behind the colon, or NULL.
static const char *value_of(const char *line)
{
    const char *value = strchr(line, ':');
    return value ? value + 1 + strspn(value + 1, " ") : NULL;
}

// The lines before the coordinates; returns the DIMENSION. Places on
// the globe have two coordinates as well, but not in a plane.
static double read_head(struct reader *reader)
{
    double dimension = -1;
    while (!is_keyword(reader->line, "NODE_COORD_SECTION")) {
        const char *value = value_of(reader->line);
        if (is_keyword(reader->line, "DIMENSION") &&
            !(read_number(value, 0, &dimension) && is_count(dimension)))
            reject(reader, "the number of points");
        if (is_keyword(reader->line, "EDGE_WEIGHT_TYPE") && value &&
            strncmp(value, "GEO", 3) == 0)
            reject(reader, "points in a plane");
        if (!next_line(reader))
            fail("%s: expected a NODE_COORD_SECTION, found none",
                 reader->name);
    }
    if (dimension < 0)
        fail("%s: expected a DIMENSION, found none", reader->name);
    return dimension;
}

static void read_tsplib(struct reader *reader, struct columns columns)
{
    struct format format = {columns, 0, false,
                            "numbers in the two columns"};
    if (!columns.x)
        format =
            (struct format){{2, 3},
                            3,
                            true,
                            "a point's number and its two coordinates"};
    double dimension = read_head(reader);
    bool ended = false;
    while (!ended && next_line(reader))
        if (is_keyword(reader->line, "EOF") ||
            strcmp(reader->line, "-1") == 0 ||
            strstr(reader->line, "_SECTION"))
            ended = true;
        else
            take_point(reader, &format);
    if (reader->points.n != dimension || !(ended || reader->complete))
        fail("%s:%zu: expected %.0f points, as DIMENSION says, found "
             "%" PRIu32 "%s",
             reader->name, reader->number, dimension, reader->points.n,
             reader->points.n == dimension ? ", the last cut short"
                                           : "");
}
//<

//> Open the file, read it, close it
struct points read_points(const char *name, struct columns columns)
{
    bool from_stdin = strcmp(name, "-") == 0;
    struct reader reader = {
        .name = from_stdin ? "standard input" : name,
        .file = from_stdin ? stdin : fopen(name, "r")};
    if (!reader.file)
        fail("cannot open %s: %s", name, strerror(errno));
    reader.line = allocate(LONGEST, 1);
    if (next_line(&reader)) {
        if (is_tsplib(reader.line))
            read_tsplib(&reader, columns);
        else
            read_table(&reader, columns);
    }
    if (reader.points.n == 0)
        fail("%s: expected points, found none", reader.name);
    free(reader.line);
    if (!from_stdin)
        fclose(reader.file);
    return reader.points;
}
//<
//<
