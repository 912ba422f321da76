//> Declare batches and their candidates
// What the stages of the batch search hand to each other. Up to eight
// queries that follow each other in a row of cells are a batch, one in
// each lane. Around them three row spans of candidates are staged, in
// single precision, for several batches at once. A kernel finds the
// best candidate of each lane, and says of which lanes it is certain.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"
#include "ch04-cell-sort/sorted.h"

//> Set the sizes of a batch
enum {
    BATCH = 8,   // queries
    ROWS = 3,    // below, the queries' own, above
    STAGED = 80, // places for a row,
    PAD = 8,     // of which so many stay free at each end
    STEP = 4,    // candidates that a sweep takes at a time
    PLACES = ROWS * STAGED,
    PLACE_MASK = 0xFF // the bits of a float that hold a place
};
_Static_assert(PLACES <= PLACE_MASK + 1,
               "eight bits number all places");
_Static_assert(STEP <= PAD, "a sweep's last step ends in the pad");
_Static_assert(BATCH <= PAD, "so do eight places from a query on");

// A squared distance beyond any that are compared, whose low bits are
// 0, and a coordinate whose square is beyond that. What is at FAR is no
// query's neighbor. It may be named by a lane without a query, and by a
// query that met no candidate, which is not certified.
static const float FAR2 = 0x1p100f, FAR = 0x1p60f;
//<

//> Hold the scene
// What a search looks at; it stays the same for all queries.
struct span_kernels;

struct scene {
    struct space space;
    const struct sorted *sorted; // points, cells, grid
    const struct span_kernels *kernels;
};
//<

//> Hold the staging buffer
// Coordinates are measured from an origin near the queries, so that
// single precision is enough for them. Row r has the places from
// r * STAGED on: a pad of FAR, the candidates, a pad of FAR; what is
// left before the next row is not read. The columns first .. last are
// staged, counted on beyond the grid where it wraps around: -1 is the
// last one, seen one period back. There a row has two parts, and the
// second begins with the column seam.
struct staging {
    double x, y;      // the origin
    double reach;     // no candidate is further from it, on either axis
    double max_reach; // for more than a batch it must not be more
    int64_t first, last, seam;
    int64_t fold[2]; // for each part: what to add to get a column
    struct staged_row {
        const uint32_t *start; // its cells; NULL: there is no such row
        uint32_t shift[2];     // from sorted points to places
    } row[ROWS];
    float place_x[PLACES], place_y[PLACES]; // seen from the origin
    uint32_t index[PLACES];                 // among the sorted points
    uint32_t place[PLACES]; // place[k] is k, to be loaded as a vector
};
//<

//> Hold a batch
struct query_batch {
    uint32_t begin, width; // the sorted points begin .. + width - 1
    uint32_t own;          // the place of the first of them
    uint32_t from[ROWS], to[ROWS]; // places of candidates, from .. to-1
    struct block block;            // the cells that these come from
};
//<

//> Hold the best two of each lane
// Squared distances, or what else is compared: the least is best. The
// low bits are the place of the candidate.
struct best_two {
    float best[BATCH], second[BATCH];
};
//<

//> Hold the results of a batch
struct batch_result {
    double distance2[BATCH];
    uint32_t candidate[BATCH]; // index among the sorted points
};
//<

//> Declare a kernel
// Finds the best candidate of each query of a batch, and its distance
// in double precision. Returns a bit for each lane: whether no other
// point can be better, or as good. Reads BATCH sorted points from the
// batch's first on; the bits and results of the lanes beyond its width
// are not used.
typedef uint32_t batch_kernel(const struct scene *scene,
                              const struct staging *staging,
                              const struct query_batch *batch,
                              struct batch_result *result);
//<

//> Know when single precision is sure
// How far two squared distances in single precision can be off, besides
// 2^-12 of the lesser one.
#define NEAR_SLACK 0x1p-27f
static const float RELATIVE_SLACK = 0x1p-12f;

static inline float near_slack(const struct staging *staging)
{
    return (float)(staging->reach * staging->reach) * NEAR_SLACK;
}

// So that the squares are far from what floats can hold.
static const double MIN_REACH = 0x1p-40, MAX_REACH = 0x1p+44;
//<

//> Read the place in the low bits
static inline uint32_t place_of(float best)
{
    union {
        float value;
        uint32_t bits;
    } number = {best};
    return number.bits & PLACE_MASK;
}
//<
//<
