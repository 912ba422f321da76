// Nothing may follow a number, a count must be whole, a name known.
#include "near/values.h"
#include "common/fail.h"
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

double parse_count(const char *option, const char *text, double min,
                   double max)
{
    char *end;
    double number = strtod(text, &end);
    if (!isdigit((unsigned char)*text) ||
        tolower((unsigned char)text[1]) == 'x' || *end ||
        number != floor(number) || number < min || number > max)
        fail("%s: expected a whole number from %.0f to %.0f, found "
             "\"%s\"",
             option, min, max, text);
    return number;
}

// Whether the text is exactly count numbers with commas between them.
static bool parse_numbers(const char *text, double *numbers, int count)
{
    if (strpbrk(text, "xX")) // hexadecimal, says strtod; not we
        return false;
    for (int k = 0; k < count; k++) {
        char *end;
        numbers[k] = strtod(text, &end);
        if (end == text || !isfinite(numbers[k]) ||
            *end != (k < count - 1 ? ',' : 0))
            return false;
        text = end + 1;
    }
    return true;
}

double parse_number(const char *option, const char *text, double min,
                    double max)
{
    double number;
    if (!parse_numbers(text, &number, 1) || number < min ||
        number > max)
        fail("%s: expected a number from %g to %g, found \"%s\"",
             option, min, max, text);
    return number;
}

double parse_distance(const char *option, const char *text)
{
    double distance;
    if (!parse_numbers(text, &distance, 1) || signbit(distance))
        fail("%s: expected a distance, 0 or more, found \"%s\"", option,
             text);
    return distance;
}

uint64_t parse_seed(const char *text)
{
    char *end;
    errno = 0;
    uint64_t seed = strtoull(text, &end, 10);
    if (!isdigit((unsigned char)*text) || *end || errno)
        fail("-s: expected a whole number below 2^64, found \"%s\"",
             text);
    return seed;
}

const char *parse_name(const char *option, const char *expected,
                       const char *text)
{
    if (!*text)
        fail("%s: expected %s, found nothing", option, expected);
    return text;
}

struct columns parse_columns(const char *text)
{
    double numbers[2];
    if (!parse_numbers(text, numbers, 2) || numbers[0] == numbers[1] ||
        numbers[0] < 1 || numbers[1] < 1 || numbers[0] > 1e6 ||
        numbers[1] > 1e6 || numbers[0] != floor(numbers[0]) ||
        numbers[1] != floor(numbers[1]))
        fail("--columns: expected two column numbers such as 2,3, "
             "found \"%s\"",
             text);
    return (struct columns){(int)numbers[0], (int)numbers[1]};
}

void parse_box(double box[static 4], const char *text)
{
    if (!parse_numbers(text, box, 4) || !(box[0] < box[2]) ||
        !(box[1] < box[3]) || !isfinite(box[2] - box[0]) ||
        !isfinite(box[3] - box[1]))
        fail("--box: expected X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1 and "
             "finite sides, found \"%s\"",
             text);
}

enum geometry parse_geometry(const char *text)
{
    if (strcmp(text, "standard") == 0)
        return STANDARD;
    if (strcmp(text, "wraparound") == 0)
        return WRAPAROUND;
    fail("-g: expected standard or wraparound, found \"%s\"", text);
}

const struct distribution *parse_distribution(const char *program,
                                              const char *text)
{
    const struct distribution *found = find_distribution(text);
    if (!found)
        fail("-d: there is no distribution \"%s\"; see %s --list", text,
             program);
    return found;
}

const struct algorithm *parse_algorithm(const char *text)
{
    const struct algorithm *found = find_algorithm(text);
    if (!found)
        fail("-a: there is no algorithm \"%s\"; see near --list", text);
    return found;
}
