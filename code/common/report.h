// Says on what machine, with which compiler and flags, and when the
// numbers below it were measured: lines that begin with '#'. Rows below
// it begin with a word.
#pragma once
#include <stdio.h>

void report_provenance(FILE *out);
