// Threads take what is in order and stop before what is not: before a
// line without a point, or one that ends them. What they leave is taken
// a line at a time, with a message if there must be one. So the points,
// the sentences and the numbers of lines are those of a single pass.
#include "common/collect.h"
#include "common/allocate.h"
#include "common/chunk.h"
#include "common/fail.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum {
    SMALLEST_PART = STRETCH / 8,       // that is worth a thread
    SHORTEST_LINE = 4,                 // with a point: 1, space, 2, end
    ROOM = STRETCH / SHORTEST_LINE + 1 // for the points of a part
};

struct part {
    struct lines lines;
    struct points points;
};

struct collector collector_of(struct stream *stream, int threads)
{
    struct collector collector = {
        .lines = lines_of(stream),
        .threads = threads,
        .parts = allocate(threads, sizeof(struct part)),
    };
    for (int k = 0; k < threads; k++)
        collector.parts[k] =
            (struct part){lines_of(stream), points_allocate(ROOM)};
    return collector;
}

void collector_free(struct collector *collector)
{
    for (int k = 0; k < collector->threads; k++) {
        lines_free(&collector->parts[k].lines);
        points_free(&collector->parts[k].points);
    }
    free(collector->parts);
    lines_free(&collector->lines);
}

static void grow(struct collector *collector, uint32_t needed)
{
    struct points *points = &collector->points;
    uint32_t capacity = points->n < (UINT32_MAX - 1000) / 2
                            ? 2 * points->n + 1000
                            : UINT32_MAX;
    capacity = capacity > needed ? capacity : needed;
    struct points larger = points_allocate(capacity);
    if (points->n > 0) {
        memcpy(larger.x, points->x, points->n * sizeof(double));
        memcpy(larger.y, points->y, points->n * sizeof(double));
    }
    larger.n = points->n;
    points_free(points);
    *points = larger;
    collector->capacity = capacity;
}

static void append(struct collector *collector, struct points more)
{
    struct points *points = &collector->points;
    if (more.n == 0)
        return;
    if (more.n > collector->capacity - points->n)
        grow(collector, points->n + more.n);
    memcpy(points->x + points->n, more.x, more.n * sizeof(double));
    memcpy(points->y + points->n, more.y, more.n * sizeof(double));
    points->n += more.n;
}

void collect_line(struct collector *collector,
                  const struct line_format *format)
{
    const struct lines *lines = &collector->lines;
    double point[2];
    const char *expected = read_point(lines->line, format, point);
    if (expected)
        reject(lines, expected);
    if (collector->points.n == UINT32_MAX)
        fail("%s:%zu: expected at most %" PRIu32 " points, found more",
             lines->stream->name, lines->number, UINT32_MAX);
    append(collector, (struct points){1, &point[0], &point[1]});
}

// Stops where it has not room for so many points.
static void take_part(struct part *part, uint32_t room,
                      const struct line_format *format)
{
    struct points *points = &part->points;
    points->n = 0;
    while (points->n < room) {
        const struct lines before = part->lines;
        double point[2];
        if (!take_line(&part->lines))
            return;
        if (ends_points(part->lines.line, format) ||
            read_point(part->lines.line, format, point)) {
            part->lines = before;
            return;
        }
        points->x[points->n] = point[0];
        points->y[points->n++] = point[1];
    }
}

// Cuts the text that is there into parts of whole lines.
static void cut(struct collector *collector, int parts)
{
    const char *next = collector->lines.next;
    const char *end = collector->lines.end;
    const size_t bytes = end - next;
    for (int k = 0; k < parts; k++) {
        struct lines *lines = &collector->parts[k].lines;
        const char *limit =
            collector->lines.next + chunk_begin(bytes, k + 1, parts);
        const char *newline =
            limit > next ? memchr(limit - 1, '\n', end - limit + 1)
                         : next - 1;
        char *copy = lines->copy;
        *lines = collector->lines;
        lines->copy = copy;
        lines->number = 0;
        lines->next = next;
        lines->end = next = newline ? newline + 1 : end;
    }
}

// Whether a part was taken to its end.
static bool put_together(struct collector *collector,
                         const struct part *part)
{
    struct lines *lines = &collector->lines;
    append(collector, part->points);
    lines->next = part->lines.next;
    lines->number += part->lines.number;
    lines->complete = part->lines.complete;
    return part->lines.next == part->lines.end;
}

static void take_parts(struct collector *collector,
                       const struct line_format *format)
{
    struct part *part = collector->parts;
    const size_t bytes = collector->lines.end - collector->lines.next;
    const size_t worth = bytes / SMALLEST_PART + 1;
    const uint32_t left = UINT32_MAX - collector->points.n;
    int parts = collector->threads;
    parts = left < (uint64_t)ROOM * parts ? 1 : parts;
    parts = worth < (size_t)parts ? (int)worth : parts;
    cut(collector, parts);
#pragma omp parallel for num_threads(parts) if (parts > 1)
    for (int k = 0; k < parts; k++)
        take_part(&part[k], left < ROOM ? left : ROOM, format);
    for (int k = 0; k < parts && put_together(collector, &part[k]); k++)
        ;
}

bool collect_lines(struct collector *collector,
                   const struct line_format *format)
{
    for (;;) {
        take_parts(collector, format);
        if (!next_line(&collector->lines))
            return false;
        if (ends_points(collector->lines.line, format))
            return true;
        collect_line(collector, format);
    }
}
