// Numbers as text, read and written exactly: what is written has the
// fewest digits that read back as the same double. There are two ways
// behind these functions, and a test holds them equal: numbers.c needs
// the C library alone, charconv.cc a C++ library, and a fifth of the
// time. The Makefile takes the second where it can.
#pragma once
#ifdef __cplusplus
extern "C" {
#endif

// The decimal number that the text begins with, or an infinity or NaN,
// rounded to the nearest double. Returns where it ends; the text itself
// if it begins with no number, or with white space.
const char *number_from_text(const char *text, double *number);

// Writes the number, and no null character behind it; returns its end.
// At most LONGEST_NUMBER characters are touched. Large and small ones
// have an exponent.
enum { LONGEST_NUMBER = 32 };
char *number_to_text(char *text, double number);

#ifdef __cplusplus
}
#endif
