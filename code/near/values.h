// The values of options, taken strictly: a sentence names the option,
// what was expected and what was found.
#pragma once
#include "algorithms.h"
#include "common/generate.h"
#include "common/read_points.h"

// A whole number from min to max; 1e5 is one.
double parse_count(const char *option, const char *text, double min,
                   double max);
double parse_number(const char *option, const char *text, double min,
                    double max);
double parse_distance(const char *option, const char *text);
uint64_t parse_seed(const char *text);
// Anything but nothing; expected says what it names.
const char *parse_name(const char *option, const char *expected,
                       const char *text);
struct columns parse_columns(const char *text);
void parse_box(double box[static 4], const char *text);
enum geometry parse_geometry(const char *text);
// The program lists what there is.
const struct distribution *parse_distribution(const char *program,
                                              const char *text);
const struct algorithm *parse_algorithm(const char *text);
