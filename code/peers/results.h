//> Declare the table of results
// A row for every program on every ground, all times in ns a point.
// What was not measured is nan; a program that was not run has the time
// that was expected.
#pragma once
#include "peers/contest.h"
#include <stdio.h>

void print_columns(FILE *out);
void print_result(FILE *out, const char *program, const char *kind,
                  uint32_t n, const char *order, int leaf,
                  const struct result *result);
//<
