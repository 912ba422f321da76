// Reads the two coordinates of a line, or says what was expected. One
// pass over the fields of a line. Where a number ends its field does,
// so that no character of it is looked at twice.
#include "common/point_line.h"
#include "common/fields.h"
#include <math.h>
#include <stddef.h>
#include <string.h>

// What the fields of a line say.
struct found {
    double x, y, number;
    int fields;
    bool bad;      // one of them is no number
    bool vanished; // one of them is 0 only in a double
};

static struct found find_numbers(const char *line,
                                 const struct line_format *format)
{
    struct found found = {.number = 1};
    const struct columns c = format->columns;
    for (const char *field = line, *end; field;
         field = next_field(end, format->separator)) {
        const int column = ++found.fields;
        double *number = column == c.x   ? &found.x
                         : column == c.y ? &found.y
                                         : NULL;
        if (column == 1 && format->numbered)
            number = &found.number;
        end = field;
        if (!number)
            continue;
        end = read_number(field, format->separator, number);
        found.bad |= !end;
        if (end && *number == 0) { // but not 0 as written?
            const char first = field[strspn(field, "+-0.")];
            found.vanished |= '1' <= first && first <= '9';
        }
        end = end ? end : field;
    }
    found.bad |= found.fields < c.x || found.fields < c.y;
    return found;
}

const char *read_point(const char *line,
                       const struct line_format *format,
                       double point[static 2])
{
    const struct found found = find_numbers(line, format);
    const bool other_fields =
        format->fields && found.fields != format->fields;
    if (other_fields && format->fields_first)
        return format->expected_fields;
    if (found.bad || !is_count(found.number))
        return format->expected;
    if (!isfinite(found.x) || !isfinite(found.y))
        return "finite numbers";
    if (found.vanished)
        return "numbers that a double can tell from 0";
    if (other_fields)
        return format->expected_fields;
    point[0] = found.x;
    point[1] = found.y;
    return NULL;
}

bool is_keyword(const char *line, const char *keyword)
{
    size_t length = strlen(keyword);
    return strncmp(line, keyword, length) == 0 &&
           strchr(" \t:", line[length]);
}

bool ends_points(const char *line, const struct line_format *format)
{
    return format->ended_by_word &&
           (is_keyword(line, "EOF") || strcmp(line, "-1") == 0 ||
            strstr(line, "_SECTION"));
}
