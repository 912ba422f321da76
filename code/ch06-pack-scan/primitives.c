//> Choose the primitives
// See primitives.h.
#include "ch06-pack-scan/primitives.h"
#include "ch06-pack-scan/avx2.h"
#include "ch06-pack-scan/avx512.h"
#include "ch06-pack-scan/portable.h"
#include <assert.h>

const struct primitives *primitives(enum isa isa)
{
    assert(isa_present(isa) && "its instructions would be illegal");
#ifdef HAVE_X86_VECTORS
    if (isa == AVX512)
        return &avx512_primitives;
    if (isa == AVX2)
        return &avx2_primitives;
#endif
    return &portable_primitives;
}
//<
