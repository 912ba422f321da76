//> Declare the search in plain C
// Runs everywhere.
#pragma once
#include "ch09-row-spans/manners.h"

span_search portable_spans;
//<
