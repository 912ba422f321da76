//> Sort records into cells
// Count the points of every bucket of cells, scan, write each point's
// record into its bucket, then sort each bucket by cell. Everything is
// read in streams, and written in as many streams as there are buckets
// or into a cache. Two passes over the points, two over the records.
#include "ch05-collisions/partition.h"
#include "ch05-collisions/shared.h"
#include "common/chunk.h"
#include "common/min_max.h"
#include <string.h>

//> Choose the width of a bucket
// Bucket b holds the cells from b << shift on. The records of 2^11
// cells and what becomes of them are some 150 KB if there are 1.5 in
// each: a small part of a second-level cache. A small grid is cut into
// at least so many buckets, for the threads to share.
enum { MAX_SHIFT = 11, MIN_BUCKETS = 128, STRIP = 512 };

static int bucket_shift(uint32_t m)
{
    int shift = MAX_SHIFT;
    while (shift > 0 && m >> shift < MIN_BUCKETS)
        shift--;
    return shift;
}
//<

//> Pack a point into a record
struct record {
    double x, y;
    uint32_t cell, point;
};
//<

//> Hold what all threads work on
// Threads take the points in chunks, in order.
struct buckets {
    const struct grid *grid;
    struct points points;
    int chunks, shift;
    uint32_t count;        // of buckets
    uint32_t *begin;       // begin[0 .. count], of records
    uint32_t *next;        // next[chunk * count + bucket]
    struct record *record; // record[0 .. n-1]
};
//<

//> Count the points of every bucket
// The cells are computed anew when they are needed again: that is
// cheaper than to write them down.
static void count_buckets(const struct buckets *buckets)
{
    const struct points p = buckets->points;
#pragma omp parallel for num_threads(buckets->chunks)
    for (int k = 0; k < buckets->chunks; k++) {
        uint32_t *mine = buckets->next + (size_t)k * buckets->count;
        uint32_t i = chunk_begin(p.n, k, buckets->chunks);
        uint32_t end = chunk_begin(p.n, k + 1, buckets->chunks);
        uint32_t cell[STRIP], count;
        memset(mine, 0, buckets->count * sizeof *mine);
        for (; i < end; i += count) {
            count = MIN(end - i, STRIP);
            find_cell_ids(buckets->grid, p, i, i + count, cell);
            for (uint32_t s = 0; s < count; s++)
                mine[cell[s] >> buckets->shift]++;
        }
    }
}
//<

//> Write every record to its bucket
static void write_chunk(const struct buckets *buckets, int k,
                        uint32_t *permutation)
{
    const struct points p = buckets->points;
    uint32_t *next = buckets->next + (size_t)k * buckets->count;
    uint32_t i = chunk_begin(p.n, k, buckets->chunks);
    uint32_t end = chunk_begin(p.n, k + 1, buckets->chunks);
    uint32_t cell[STRIP], count;
    for (; i < end; i += count) {
        count = MIN(end - i, STRIP);
        find_cell_ids(buckets->grid, p, i, i + count, cell);
        for (uint32_t s = 0; s < count; s++) {
            uint32_t at = next[cell[s] >> buckets->shift]++;
            buckets->record[at] =
                (struct record){p.x[i + s], p.y[i + s], cell[s], i + s};
            if (permutation)
                permutation[i + s] = at;
        }
    }
}
//<

//> Sort a bucket
// The records begin .. end - 1, all for the cells first .. last - 1. It
// is the records' numbers that are placed, 4 bytes each; then all that
// stays of a record is read from there, and written in streams. Where
// no inverse is wanted, the numbers stand in for the points at first.
struct span_of_cells {
    uint32_t first, last;
};

static void sort_bucket(const struct record *record, uint32_t begin,
                        uint32_t end, struct span_of_cells cells,
                        const struct partition *partition)
{
    const struct sorted *sorted = &partition->sorted;
    uint32_t *from =
        partition->inverse ? partition->inverse : sorted->cells.point;
    uint32_t *next = sorted->cells.start + 1;
    //> Count, scan and place the records of a bucket
    memset(next + cells.first, 0,
           (cells.last - cells.first) * sizeof *next);
    for (uint32_t k = begin; k < end; k++)
        next[record[k].cell]++;
    cells_scan(next + cells.first, cells.last - cells.first, begin);
    for (uint32_t k = begin; k < end; k++)
        from[next[record[k].cell]++] = k;
    //<
    //> Unpack the records in the order of the cells
    for (uint32_t s = begin; s < end; s++) {
        const struct record *r = &record[from[s]];
        sorted->points.x[s] = r->x;
        sorted->points.y[s] = r->y;
        sorted->cells.point[s] = r->point;
    }
    //<
}
//<

//> Partition, then sort bucket by bucket
static void sort_records(const struct buckets *buckets,
                         const struct partition *partition)
{
    const uint32_t m = grid_cells(buckets->grid);
    const uint32_t width = (uint32_t)1 << buckets->shift;
    count_buckets(buckets);
    scan_chunks(buckets->next, buckets->count, buckets->chunks,
                buckets->begin);
#pragma omp parallel for num_threads(buckets->chunks)
    for (int k = 0; k < buckets->chunks; k++)
        write_chunk(buckets, k, partition->permutation);
    partition->sorted.cells.start[0] = 0;
#pragma omp parallel for num_threads(buckets->chunks) schedule(dynamic)
    for (uint32_t b = 0; b < buckets->count; b++) {
        uint32_t first = b * width;
        uint32_t last = m - first < width ? m : first + width;
        sort_bucket(buckets->record, buckets->begin[b],
                    buckets->begin[b + 1],
                    (struct span_of_cells){first, last}, partition);
    }
}
//<

//> Take the arrays that stay
static struct partition take_result(uint32_t n, uint32_t m,
                                    enum restore restore,
                                    struct workspace *workspace)
{
    const size_t index = sizeof(uint32_t), number = sizeof(double);
    struct partition result = {0};
    struct sorted *sorted = &result.sorted;
    sorted->cells.start = workspace_take(workspace, m + 1, index);
    sorted->cells.point = workspace_take(workspace, n, index);
    sorted->points =
        (struct points){n, workspace_take(workspace, n, number),
                        workspace_take(workspace, n, number)};
    if (restore) {
        result.permutation = workspace_take(workspace, n, index);
        result.inverse = workspace_take(workspace, n, index);
    }
    return result;
}
//<

//> Add up the arrays of a partition
// What stays: coordinates and up to three indices a point, and the
// starts. On top of it first the records and the counts of buckets, and
// later, in the place of the records, the results of searches and two
// numbers for each row. Each array begins on a cache line of its own.
static size_t bytes_for(const struct buckets *buckets, uint32_t m,
                        enum restore restore)
{
    enum { ARRAYS = 9, LINE = 64, RESULT = 16 };
    const size_t index = sizeof(uint32_t), n = buckets->points.n;
    const size_t above = MAX(sizeof *buckets->record, restore * RESULT);
    const size_t point =
        above + 2 * sizeof(double) + (restore ? 3 : 1) * index;
    return n * point + ((size_t)m + 2) * index +
           ((size_t)buckets->chunks + 1) * buckets->count * index +
           2 * (size_t)buckets->grid->y.count * index + ARRAYS * LINE;
}
//<

//> Partition points in a workspace
struct partition partition_points(const struct grid *grid,
                                  struct points points, int threads,
                                  enum restore restore,
                                  struct workspace *workspace)
{
    const uint32_t m = grid_cells(grid);
    struct buckets buckets = {.grid = grid,
                              .points = points,
                              .chunks = threads,
                              .shift = bucket_shift(m)};
    buckets.count = ((m - 1) >> buckets.shift) + 1;
    workspace_reserve(workspace, bytes_for(&buckets, m, restore),
                      threads);
    struct partition result =
        take_result(points.n, m, restore, workspace);
    result.sorted.grid = *grid;
    struct mark mark = workspace_mark(workspace);
    //> Take the arrays of the buckets
    // Above a mark: they are given up when the points are sorted.
    const size_t index = sizeof *buckets.next, count = buckets.count;
    buckets.begin = workspace_take(workspace, count + 1, index);
    buckets.next = workspace_take(workspace, threads * count, index);
    buckets.record =
        workspace_take(workspace, points.n, sizeof *buckets.record);
    //<
    sort_records(&buckets, &result);
    workspace_release(workspace, mark);
    return result;
}
//<

struct partition partition_make(const struct question *question,
                                double c, enum restore restore,
                                struct workspace *workspace)
{
    struct grid grid = grid_fit_in(workspace, question, c);
    struct partition result = partition_points(
        &grid, question->points, question->threads, restore, workspace);
    note_built(question);
    return result;
}
//<
