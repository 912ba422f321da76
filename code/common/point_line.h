// A line of text that holds a point: which of its fields are the
// coordinates, and what else must be so.
#pragma once
#include <stdbool.h>

// Which columns of a table hold x and y, counted from 1; both 0: there
// are no others.
struct columns {
    int x, y;
};

struct line_format {
    struct columns columns; // of x and y
    char separator;
    bool numbered;        // the first field is the point's number
    bool ended_by_word;   // TSPLIB: the points, at a line of its kind
    const char *expected; // in a line
    int fields;           // in a line; 0: any number
    bool fields_first;    // they are looked at before the numbers
    char expected_fields[64];
};

// The point in a line. Returns NULL, or what was expected if there is
// none in it.
const char *read_point(const char *line,
                       const struct line_format *format,
                       double point[static 2]);

// Whether the line begins with this word.
bool is_keyword(const char *line, const char *keyword);

// Whether no point follows, if lines of this format end by a word.
bool ends_points(const char *line, const struct line_format *format);
