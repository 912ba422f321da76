// A line's fields, separated by one character, and the numbers in them.
// The separator ' ' stands for any number of spaces. What is between
// double quotes separates nothing.
#pragma once
#include <stdbool.h>
#include <stdint.h>

// ';' if the line has one outside of quotes, or else ',', or else a
// tab, or else ' '.
char separator_of(const char *line);

// The first of this character outside of quotes, or the line's end.
const char *field_end(const char *line, char separator);

// How many fields the line has, at least one.
int count_fields(const char *line, char separator);

// The field in this column, from 1; NULL if the line has fewer.
const char *find_field(const char *line, char separator, int column);

// The field behind the one with this place in it; NULL if that is the
// last.
const char *next_field(const char *place, char separator);

// The end of a field that is a number and nothing else; NULL if it is
// not. The number may be infinite or no number at all in the sense of
// IEEE 754, but not hexadecimal.
const char *read_number(const char *field, char separator,
                        double *number);

// Whether the field may be the head of a column. A missing value is
// none, nor a number in quotes, nor what people write or type for one:
// l.5, or a minus sign of another script.
bool is_word(const char *field, char separator);

// Whether the number could count points.
bool is_count(double number);
