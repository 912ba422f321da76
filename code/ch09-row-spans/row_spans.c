//> Search by row spans
// See row_spans.h.
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/avx2_spans.h"
#include "ch09-row-spans/avx512_spans.h"
#include "ch09-row-spans/carry.h"
#include "ch09-row-spans/portable_spans.h"
#include "common/clock.h"
#include "common/isa.h"
#include <assert.h>
#include <stddef.h>

#ifdef COUNTING
#define search_row_spans counting_search_row_spans
#define search_in_turns counting_search_in_turns
#define search_and_visit counting_search_and_visit
#endif

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

//> Take a turn
// The answers are found in the order of the cells, and then carried to
// their places in the order of the input, all in one go.
static void take_turn(span_search *search,
                      const struct question *question,
                      const struct sorted *sorted, enum manner manner,
                      const struct visit *visit, uint32_t begin,
                      uint32_t end, struct answers *answers)
{
    uint32_t nearest[LONGEST_TURN];
    double nearest2[LONGEST_TURN];
    struct answers found = {.nearest = nearest, .nearest2 = nearest2};
    const uint32_t *point = sorted->cells.point;
    search(question, sorted, manner, visit, begin, end, &found);
    if (!answers->nearest)
        return;
    for (uint32_t s = begin; s < end; s++) {
        answers->nearest[point[s]] = nearest[s - begin];
        answers->nearest2[point[s]] = nearest2[s - begin];
    }
}
//<

//> Take turns
// A crowded cell is many turns, for all threads.
static void take_turns(const struct question *question,
                       const struct sorted *sorted, enum manner manner,
                       const struct visit *visit, uint32_t length,
                       struct answers *answers)
{
    assert(1 <= length && length <= LONGEST_TURN &&
           "a turn keeps its answers");
    span_search *search = search_for(isa_chosen());
    const uint32_t n = sorted->points.n, turns = (n - 1) / length + 1;
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic)
    for (uint32_t turn = 0; turn < turns; turn++) {
        uint32_t begin = turn * length, left = n - begin;
        take_turn(search, question, sorted, manner, visit, begin,
                  begin + (left < length ? left : length), answers);
    }
}
//<

void search_in_turns(const struct question *question,
                     const struct sorted *sorted, enum manner manner,
                     uint32_t length, struct answers *answers)
{
    take_turns(question, sorted, manner, NULL, length, answers);
}

void search_row_spans(const struct question *question,
                      const struct sorted *sorted, enum manner manner,
                      struct answers *answers)
{
    take_turns(question, sorted, manner, NULL, LONGEST_TURN, answers);
}

void search_and_visit(const struct question *question,
                      const struct sorted *sorted,
                      const struct visit *visit,
                      struct answers *answers)
{
    take_turns(question, sorted, TOGETHER, visit, LONGEST_TURN,
               answers);
}

void row_spans(const struct question *question, struct answers *answers)
{
    struct sorted sorted = sorted_carry(question, POINTS_PER_SPAN_CELL);
    answers->built_ns = clock_ns();
    search_row_spans(question, &sorted, TOGETHER, answers);
    sorted_free(&sorted);
}
//<
