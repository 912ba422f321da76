// The head is taken strictly: it is as NumPy writes it, or it is
// refused. Of the numbers, each is taken from the stretch of the file
// that it is in, so that memory does not depend on the columns.
#include "common/read_npy.h"
#include "common/fail.h"
#include "common/lines.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "numbers are read as they lie in the file");

static const char magic[] = "\x93NUMPY";
enum { MAGIC = 6, LONGEST_HEAD = 10000 };
_Static_assert(LONGEST_HEAD + 12 <= LONGEST_LINE,
               "a stream has room for either");

struct array {
    uint64_t rows, columns;
    bool by_columns; // Fortran's order: one column after the other
};

bool is_npy(struct stream *stream)
{
    size_t length;
    do {
        length = stream->length < MAGIC ? stream->length : MAGIC;
        if (memcmp(stream->bytes, magic, length) != 0)
            return false;
    } while (length < MAGIC && stream_more(stream) > 0);
    return length == MAGIC;
}

static void insist_on(struct stream *stream, size_t bytes)
{
    while (stream->length < bytes)
        if (stream_more(stream) == 0)
            fail("%s: expected the head of an array, found its first "
                 "%zu bytes",
                 stream->name, stream->length);
}

// The text of the head; what follows are the numbers. Returns how many
// bytes came before them.
static size_t read_head(struct stream *stream,
                        char head[static LONGEST_HEAD + 1])
{
    insist_on(stream, 12);
    const unsigned char *bytes = (unsigned char *)stream->bytes;
    const int version = bytes[6];
    size_t begin = 10, length = bytes[8] | bytes[9] << 8;
    if (version >= 2) {
        begin = 12;
        length |= (size_t)bytes[10] << 16 | (size_t)bytes[11] << 24;
    }
    if (version < 1 || version > 3 || bytes[7] != 0)
        fail("%s: expected version 1.0, 2.0 or 3.0 of the format, "
             "found %d.%d",
             stream->name, version, bytes[7]);
    if (length > LONGEST_HEAD)
        fail("%s: expected an array, found a head of %zu bytes",
             stream->name, length);
    insist_on(stream, begin + length);
    memcpy(head, stream->bytes + begin, length);
    head[length] = 0;
    stream_drop(stream, begin + length);
    return begin + length;
}

static _Noreturn void refuse(const struct stream *stream,
                             const char *expected, const char *found)
{
    fail("%s: expected %s, found %.*s", stream->name, expected,
         (int)strcspn(found, "\n"), found);
}

// What the head says: a dictionary of Python's, in the order in which
// NumPy writes it.
static struct array parse_head(const struct stream *stream,
                               const char *head)
{
    char type[61] = "", order[6] = "", shape[61] = "", more;
    int end = 0;
    sscanf(head,
           " { 'descr' : %60[^,], 'fortran_order' : %5[A-Za-z] , "
           "'shape' : (%60[0-9, ])%n",
           type, order, shape, &end);
    if (*type && strcmp(type, "'<f8'") != 0)
        refuse(stream, "an array of doubles, '<f8'", type);
    const char *rest = head + end + strspn(head + end, ", ");
    const bool by_columns = strcmp(order, "True") == 0;
    if (!end || *rest != '}' || rest[1 + strspn(rest + 1, " \n")] ||
        !(by_columns || strcmp(order, "False") == 0))
        refuse(stream, "the head of an array of shape (n, 2)", head);
    struct array array = {.by_columns = by_columns};
    if (sscanf(shape, "%18" SCNu64 " , %8" SCNu64 " %c", &array.rows,
               &array.columns, &more) != 2)
        refuse(stream, "an array of shape (n, 2)", shape);
    return array;
}

static void insist_on_shape(const struct stream *stream,
                            struct array array, struct columns columns)
{
    const int wanted = columns.x > columns.y ? columns.x : columns.y;
    if (columns.x ? array.columns < (uint64_t)wanted
                  : array.columns != 2)
        fail("%s: expected %d columns%s, found %" PRIu64, stream->name,
             wanted ? wanted : 2,
             !wanted && array.columns > 2 ? " (or --columns I,J)" : "",
             array.columns);
    if (array.rows > UINT32_MAX)
        fail("%s: expected at most %" PRIu32 " points, found %" PRIu64,
             stream->name, UINT32_MAX, array.rows);
}

// Of the array's elements from first on, count are in the bytes. Takes
// those of one column, from 0, into its coordinates.
static void take_column(const struct array *array, uint64_t column,
                        double *coordinates, const char *bytes,
                        const uint64_t range[2])
{
    const uint64_t stride = array->by_columns ? 1 : array->columns;
    const uint64_t start =
        array->by_columns ? column * array->rows : column;
    uint64_t row =
        range[0] > start ? (range[0] - start + stride - 1) / stride : 0;
    uint64_t at = start + row * stride;
    for (; row < array->rows && at < range[1]; row++, at += stride)
        memcpy(&coordinates[row],
               bytes + (at - range[0]) * sizeof(double),
               sizeof(double));
}

// Says how many numbers were found, if they are too few, or else that
// there are too many.
static _Noreturn void refuse_length(const struct stream *stream,
                                    uint64_t elements, uint64_t found)
{
    char count[24] = "more";
    if (found < elements)
        snprintf(count, sizeof count, "%" PRIu64, found);
    fail("%s: expected %" PRIu64 " numbers, as its head says, found %s",
         stream->name, elements, count);
}

static void insist_on_finite(const struct stream *stream,
                             struct points points)
{
    for (uint32_t i = 0; i < points.n; i++)
        if (!isfinite(points.x[i]) || !isfinite(points.y[i]))
            fail("%s: expected finite numbers, found %g and %g in row "
                 "%" PRIu32 " (from 0)",
                 stream->name, points.x[i], points.y[i], i);
}

struct points read_npy(struct stream *stream, struct columns columns)
{
    char head[LONGEST_HEAD + 1];
    const uint64_t before = read_head(stream, head);
    const struct array array = parse_head(stream, head);
    insist_on_shape(stream, array, columns);
    if (!columns.x)
        columns = (struct columns){1, 2};
    const uint64_t elements = array.rows * array.columns;
    const uint64_t size = stream_size(stream);
    if (size > 0 && (size - before) / sizeof(double) < elements)
        refuse_length(stream, elements,
                      (size - before) / sizeof(double));
    struct points points = points_allocate(array.rows);
    uint64_t range[2] = {0, 0};
    do {
        const uint64_t left = elements - range[0];
        const uint64_t there = stream->length / sizeof(double);
        range[1] = range[0] + (there < left ? there : left);
        take_column(&array, columns.x - 1, points.x, stream->bytes,
                    range);
        take_column(&array, columns.y - 1, points.y, stream->bytes,
                    range);
        stream_drop(stream, (range[1] - range[0]) * sizeof(double));
        range[0] = range[1];
    } while (range[0] < elements && stream_more(stream) > 0);
    if (range[0] < elements || stream->length > 0 ||
        stream_more(stream) > 0)
        refuse_length(stream, elements, range[0]);
    insist_on_finite(stream, points);
    return points;
}
