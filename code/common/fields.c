// Finds the fields of a line and reads the numbers in them, each in one
// pass from left to right. Decimal points are points because no program
// of ours leaves the C locale.
#include "common/fields.h"
#include "common/numbers.h"
#include <ctype.h>
#include <math.h>
#include <string.h>
#include <strings.h>

const char *field_end(const char *line, char separator)
{
    bool quoted = false;
    for (; *line && (quoted || *line != separator); line++)
        quoted ^= *line == '"';
    return line;
}

char separator_of(const char *line)
{
    for (const char *separator = ";,\t"; *separator; separator++)
        if (*field_end(line, *separator))
            return *separator;
    return ' ';
}

const char *next_field(const char *place, char separator)
{
    const char *end = field_end(place, separator);
    if (!*end)
        return NULL;
    while (*++end == ' ')
        ;
    return end;
}

int count_fields(const char *line, char separator)
{
    int count = 1;
    while ((line = next_field(line, separator)))
        count++;
    return count;
}

const char *find_field(const char *line, char separator, int column)
{
    while (line && --column > 0)
        line = next_field(line, separator);
    return line;
}

//> Read the number in a field
const char *read_number(const char *field, char separator,
                        double *number)
{
    const char *end = number_from_text(field, number);
    if (end == field)
        return NULL;
    if (separator != ' ')
        while (*end == ' ')
            end++;
    return *end == 0 || *end == separator ? end : NULL;
}
//<
bool is_count(double number)
{
    return number >= 1 && number <= UINT32_MAX &&
           number == floor(number);
}

static bool is_missing(const char *field, size_t length)
{
    static const char *const missing[] = {"NA", "N/A", "NULL", "None"};
    for (size_t k = 0; k < sizeof missing / sizeof *missing; k++)
        if (length == strlen(missing[k]) &&
            strncasecmp(field, missing[k], length) == 0)
            return true;
    return false;
}

// Whether these are letters in the places of digits, as in l.5 or O2.
static bool is_misspelled(const char *field, size_t length)
{
    return strcspn(field, "0123456789") < length &&
           strspn(field, "0123456789.+-lIOoSBZ|") >= length;
}

// The length of a sign or a digit of another script, in UTF-8: of the
// minus signs and dashes, the wide digits and the Arabic ones; or 0.
static size_t foreign_sign(const char *field)
{
    const unsigned char *c = (const unsigned char *)field;
    if (c[0] == 0xe2 && c[1] && c[2])
        return 3;
    if (c[0] == 0xef && c[1] == 0xbc && c[2] && c[2] <= 0x99)
        return 3;
    if (c[0] == 0xd9 && 0xa0 <= c[1] && c[1] <= 0xa9)
        return 2;
    return 0;
}

bool is_word(const char *field, char separator)
{
    if (!field)
        return false;
    if (*field == '"')
        field++, separator = '"';
    for (size_t sign; (sign = foreign_sign(field));)
        field += sign;
    size_t length = strcspn(field, "\" \t,;");
    double number;
    return !is_missing(field, length) &&
           !is_misspelled(field, length) &&
           !read_number(field, separator, &number) &&
           (isalpha((unsigned char)*field) || *field == '_' ||
            (unsigned char)*field >= 0x80);
}
