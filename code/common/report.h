// Says on what machine, with which compiler and flags, and when the
// numbers below it were measured: lines that begin with '#'. Rows below
// it begin with a word.
#pragma once
#include <stdbool.h>
#include <stdio.h>

void report_provenance(FILE *out);

// What Linux says about cache k of the first processor, from 0: the
// first word of a file such as level, type or size. False if there is
// none.
bool cache_says(int k, const char *what, char word[static 16]);
