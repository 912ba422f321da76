//> Declare the kernels of the row spans
// What an instruction set brings to chapter 9's search. Everything else
// is the same for all of them.
#pragma once
#include "ch09-row-spans/batch.h"
#include "ch09-row-spans/point_query.h"
#include "common/isa.h"

//> Name a part of a row
// A part of a row: sorted points, and the origin they are seen from.
struct span_source {
    uint32_t begin, end;
    double x, y;
};

// Writes a part of a row to the places from place on. May write up to
// PAD places too many.
typedef void stage_function(const struct sorted *sorted,
                            const struct span_source *source,
                            uint32_t place, struct staging *staging);
//<

//> List what a kernel table has
struct span_kernels {
    const char *name;
    stage_function *stage;
    batch_kernel *nearest;
    compare_function *compare; // a point query with a row span
};

extern const struct span_kernels portable_spans, avx2_spans,
    avx512_spans;
//<

// Those of the instruction set that is chosen.
const struct span_kernels *span_kernels(void);
//<
