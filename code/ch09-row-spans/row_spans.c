//> Search by row spans
// See row_spans.h.
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/avx2_spans.h"
#include "ch09-row-spans/avx512_spans.h"
#include "ch09-row-spans/portable_spans.h"
#include "ch09-row-spans/send_back.h"
#include "common/clock.h"
#include "common/isa.h"
#include <assert.h>
#include <stddef.h>

#ifdef COUNTING
#define search_row_spans counting_search_row_spans
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

//> Find the answers of a turn
// Takes what has been found for the sorted points begin .. end - 1.
typedef void take_function(void *context, uint32_t begin, uint32_t end,
                           const struct answers *found);

struct turns {
    const struct question *question;
    const struct sorted *sorted;
    enum manner manner;
    const struct visit *visit;
    uint32_t length;
    take_function *take;
    void *context;
};

static void find_turn(span_search *search, const struct turns *turns,
                      uint32_t begin, uint32_t end)
{
    uint32_t nearest[LONGEST_TURN], furthest[LONGEST_TURN];
    double nearest2[LONGEST_TURN], furthest2[LONGEST_TURN];
    struct answers found = {.nearest = nearest,
                            .nearest2 = nearest2,
                            .furthest = furthest,
                            .furthest2 = furthest2};
    search(turns->question, turns->sorted, turns->manner, turns->visit,
           begin, end, &found);
    turns->take(turns->context, begin, end, &found);
}
//<

//> Take turns
// A crowded cell is many turns, for all threads. But a thread takes
// some that follow each other, as long as there are plenty: they put
// their answers into the same parcels.
static int turns_at_once(uint32_t count, int threads)
{
    uint32_t share = count / 16 / (uint32_t)threads;
    return share < 1 ? 1 : share > 8 ? 8 : (int)share;
}

static void take_turns(const struct turns *turns)
{
    const uint32_t n = turns->sorted->points.n, length = turns->length;
    assert(1 <= length && length <= LONGEST_TURN &&
           "a turn keeps its answers");
    const uint32_t count = (n - 1) / length + 1;
    span_search *search = search_for(isa_chosen());
    const int threads = turns->question->threads;
#pragma omp parallel for num_threads(threads) \
    schedule(dynamic, turns_at_once(count, threads))
    for (uint32_t turn = 0; turn < count; turn++) {
        uint32_t begin = turn * length, left = n - begin;
        find_turn(search, turns, begin,
                  begin + (left < length ? left : length));
    }
}
//<

//> Take the answers of a turn home
struct straight_home {
    const uint32_t *point;
    struct answers *answers;
};

static void take_home(void *context, uint32_t begin, uint32_t end,
                      const struct answers *found)
{
    const struct straight_home *home = context;
    const uint32_t *point = home->point;
    for (uint32_t s = begin; s < end; s++) {
        home->answers->nearest[point[s]] = found->nearest[s - begin];
        home->answers->nearest2[point[s]] = found->nearest2[s - begin];
    }
}
//<

void search_in_turns(const struct question *question,
                     const struct sorted *sorted, uint32_t length,
                     struct answers *answers)
{
    struct straight_home home = {sorted->cells.point, answers};
    take_turns(&(struct turns){question, sorted, TOGETHER, NULL, length,
                               take_home, &home});
}

//> Send the answers of all turns back
struct way_back {
    const struct carried *carried;
    struct findings findings;
};

static void send_turn(void *context, uint32_t begin, uint32_t end,
                      const struct answers *found)
{
    const struct way_back *back = context;
    findings_pack(back->carried, begin, end, found, &back->findings);
}

static void search_and_send_back(const struct question *question,
                                 const struct carried *carried,
                                 enum manner manner,
                                 const struct visit *visit,
                                 struct answers *answers)
{
    struct way_back back = {carried,
                            findings_for(answers, question->points.n)};
    take_turns(&(struct turns){question, &carried->sorted, manner,
                               visit, LONGEST_TURN, send_turn, &back});
    findings_send_back(carried, &back.findings, question->threads,
                       answers);
    findings_free(&back.findings);
}
//<

void search_row_spans(const struct question *question,
                      const struct carried *carried, enum manner manner,
                      struct answers *answers)
{
    struct answers nearest = *answers;
    nearest.furthest = NULL;
    search_and_send_back(question, carried, manner, NULL, &nearest);
}

void search_and_visit(const struct question *question,
                      const struct carried *carried,
                      const struct visit *visit,
                      struct answers *answers)
{
    search_and_send_back(question, carried, TOGETHER, visit, answers);
}

void row_spans(const struct question *question, struct answers *answers)
{
    struct carried carried =
        carry_points(question, POINTS_PER_SPAN_CELL);
    answers->built_ns = clock_ns();
    search_row_spans(question, &carried, TOGETHER, answers);
    carried_free(&carried);
}
//<
