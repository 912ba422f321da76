//> Search by row spans
// See row_spans.h.
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/avx2_spans.h"
#include "ch09-row-spans/avx512_spans.h"
#include "ch09-row-spans/carry.h"
#include "ch09-row-spans/portable_spans.h"
#include "common/clock.h"
#include "common/isa.h"

// Sorted points to be answered for by a thread at a time: half a cell,
// if it is crowded.
enum { POINTS_PER_TURN = 1024 };

//> Choose the instruction set of the search
static span_search *search_for(enum isa isa)
{
#ifdef HAVE_X86_VECTORS
    if (isa == AVX512)
        return avx512_spans;
    if (isa == AVX2)
        return avx2_spans;
#endif
    (void)isa;
    return portable_spans;
}
//<

//> Share out the sorted points
void search_row_spans(const struct question *question,
                      const struct sorted *sorted, enum manner manner,
                      struct answers *answers)
{
    span_search *search = search_for(isa_chosen());
    const uint32_t n = sorted->points.n;
    const uint32_t turns = (n - 1) / POINTS_PER_TURN + 1;
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic)
    for (uint32_t turn = 0; turn < turns; turn++) {
        uint32_t begin = turn * POINTS_PER_TURN, rest = n - begin;
        search(question, sorted, manner, begin,
               begin +
                   (rest < POINTS_PER_TURN ? rest : POINTS_PER_TURN),
               answers);
    }
}
//<

void row_spans(const struct question *question, struct answers *answers)
{
    struct sorted sorted = sorted_carry(question, POINTS_PER_SPAN_CELL);
    answers->built_ns = clock_ns();
    search_row_spans(question, &sorted, TOGETHER, answers);
    sorted_free(&sorted);
}
//<
