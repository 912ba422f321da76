// The way of the C++ library: Lemire's algorithm (2021) reads and
// Adams's Ryu (2018) writes. A program that is C otherwise takes C++
// for this because no library in C has both.
#include "common/numbers.h"
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>

// A sign + is not taken there; and of numbers that overflow or vanish
// strtod knows which they did.
const char *number_from_text(const char *text, double *number)
{
    const char *first = text + (*text == '+' && text[1] != '-');
    const auto [end, error] =
        std::from_chars(first, first + std::strlen(first), *number);
    if (error == std::errc::result_out_of_range) {
        char *last;
        *number = std::strtod(text, &last);
        return last;
    }
    return end == first ? text : end;
}

char *number_to_text(char *text, double number)
{
    const double size = std::fabs(number);
    const bool plain = number == 0 || (1e-4 <= size && size < 1e15);
    return std::to_chars(text, text + LONGEST_NUMBER, number,
                         plain ? std::chars_format::fixed
                               : std::chars_format::scientific)
        .ptr;
}
