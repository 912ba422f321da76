// The way of the C library: try fewer digits before more, until the
// number reads back.
#include "common/numbers.h"
#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// What strtod takes besides is kept from it: white space, and of a
// hexadecimal number all but its zero.
const char *number_from_text(const char *text, double *number)
{
    const char *zeros = text + (*text == '+' || *text == '-');
    const char *behind = zeros + strspn(zeros, "0");
    if (isspace((unsigned char)*text))
        return text;
    if (behind > zeros && (*behind == 'x' || *behind == 'X')) {
        *number = *text == '-' ? -0.0 : 0.0;
        return behind;
    }
    char *end;
    *number = strtod(text, &end);
    return end;
}

char *number_to_text(char *text, double number)
{
    const double size = fabs(number);
    const bool plain = number == 0 || (1e-4 <= size && size < 1e15);
    int length = 0;
    for (int digits = plain ? 15 : 1; digits <= 17; digits++) {
        length = plain ? snprintf(text, LONGEST_NUMBER, "%.*g", digits,
                                  number)
                       : snprintf(text, LONGEST_NUMBER, "%.*e",
                                  digits - 1, number);
        if (strtod(text, NULL) == number)
            break;
    }
    return text + length;
}
