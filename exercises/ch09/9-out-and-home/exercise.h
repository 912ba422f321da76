// Exercise: out and home
#pragma once
#include <stdint.h>

// A point on its way out, or its result on its way home.
struct record {
    uint32_t index, cell;
};

// Far memory has four arrays of n records each. It is read and written
// in lines of LINE records, and a cache keeps the CACHE lines that were
// used last. A line that has to be fetched is counted.
enum array { INPUT, ROOM, SORTED, OUTPUT };
enum { LINE = 8, CACHE = 256, RECORDS_MOST = 100000 };

// Given. The only ways to far memory.
struct record get(enum array array, uint32_t place);
void set(enum array array, uint32_t place, struct record record);

// INPUT has n points, point i at place i, in cells less than n. Brings
// them to SORTED, in the order of their cells, and where these are
// equal in the order of their indices. n <= RECORDS_MOST.
void go_out(uint32_t n);

// SORTED has n results, in any order, each with the index of its point,
// and no two with the same. Brings the result of point i to place i of
// OUTPUT.
void go_home(uint32_t n);
