//> Choose the kernels of the row spans
// One table for each instruction set; where it is not compiled, the
// table in plain C stands in and is never asked for.
#include "ch09-row-spans/span_kernels.h"

const struct span_kernels *span_kernels(void)
{
    static const struct span_kernels *const kernels[ISA_COUNT] = {
        [PORTABLE] = &portable_spans,
#ifdef HAVE_X86_VECTORS
        [AVX2] = &avx2_spans,
        [AVX512] = &avx512_spans,
#endif
    };
    return kernels[isa_chosen()];
}
//<
