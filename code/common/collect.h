// Points from lines, collected by several threads: each takes a part of
// the text that is there, and their points are put together in order.
#pragma once
#include "common/lines.h"
#include "common/point_line.h"
#include "common/points.h"

// Bytes of text, for each thread. (tests/fuzz.c makes them few.)
#ifndef STRETCH
#define STRETCH (1 << 20)
#endif

struct collector {
    struct lines lines;
    struct points points; // collected so far
    uint32_t capacity;    // of their arrays
    int threads;
    struct part *parts; // one for each thread
};

// Collects from the stream, which has a stretch of room for each thread
// besides the longest line. Nothing collected yet.
struct collector collector_of(struct stream *stream, int threads);

// Gives up all but the points.
void collector_free(struct collector *collector);

// Takes the point of the current line, or rejects it.
void collect_line(struct collector *collector,
                  const struct line_format *format);

// Takes the points of all lines that follow, up to one that ends them,
// or to the end of the file; says whether there was such a line. Fails
// at the first line that holds no point.
bool collect_lines(struct collector *collector,
                   const struct line_format *format);
