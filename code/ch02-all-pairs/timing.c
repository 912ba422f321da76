//> Time rows
// See timing.h.
#include "ch02-all-pairs/timing.h"
#include "common/generate.h"
#include <stdio.h>

void run_rows(void *context)
{
    struct run *run = context;
    run->rows(run->question, run->answers, run->begin, run->end);
}

void run_search(void *context)
{
    struct search *search = context;
    search->search(&search->question, search->answers);
}

struct question kind_question(const char *kind, uint32_t n,
                              uint64_t seed)
{
    return (struct question){
        .points = generate(find_distribution(kind), n, seed),
        .space = {STANDARD, 1, 1},
        .threads = 1,
    };
}

struct question uniform_question(enum geometry geometry, uint32_t n,
                                 uint64_t seed)
{
    struct question question = kind_question("uniform", n, seed);
    question.space.geometry = geometry;
    return question;
}

void print_summary_columns(const char *name)
{
    printf("\t%s\t%s_q1\t%s_q3", name, name, name);
}

void print_summary(const struct summary *summary, double count)
{
    printf("\t%.4g\t%.4g\t%.4g", summary->median / count,
           summary->q1 / count, summary->q3 / count);
}
//<
