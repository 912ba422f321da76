// The values of near's options, taken strictly: a sentence names the
// option, what was expected and what was found.
#pragma once
#include "algorithms.h"
#include "common/generate.h"
#include "common/read_points.h"

// A whole number from min to max; 1e5 is one.
double parse_count(const char *option, const char *text, double min,
                   double max);
double parse_distance(const char *option, const char *text);
uint64_t parse_seed(const char *text);
struct columns parse_columns(const char *text);
void parse_box(double box[static 4], const char *text);
enum geometry parse_geometry(const char *text);
const struct distribution *parse_distribution(const char *text);
const struct algorithm *parse_algorithm(const char *text);
