// The triangular loop with private answers, its rows handed out under
// each of OpenMP's schedules with smaller and larger chunks.
//
//     schedules [POINTS [TRIALS]]
#include "ch03-half-pairs/private.h"
#include "common/experiment.h"
#include <omp.h>

struct entry {
    omp_sched_t schedule;
    int chunk;
    const struct question *question;
    struct answers *answers;
};

static void run_entry(void *context)
{
    struct entry *entry = context;
    triangle_private(entry->question, entry->answers, entry->schedule,
                     entry->chunk);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 2000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    question.threads = omp_get_num_procs();
    struct answers answers = answers_allocate(n);

    static const struct {
        const char *name;
        omp_sched_t schedule;
    } kinds[] = {{"static", omp_sched_static},
                 {"dynamic", omp_sched_dynamic},
                 {"guided", omp_sched_guided}};
    enum { CHUNKS = 6, ENTRIES = 3 * CHUNKS + 1 };
    struct entry entries[ENTRIES];
    struct trial turns[ENTRIES];
    for (int e = 0; e < ENTRIES; e++) { // the last: static, undivided
        omp_sched_t kind =
            kinds[e < 3 * CHUNKS ? e / CHUNKS : 0].schedule;
        int chunk = e < 3 * CHUNKS ? 1 << 2 * (e % CHUNKS) : 0;
        entries[e] = (struct entry){kind, chunk, &question, &answers};
        turns[e] =
            (struct trial){.work = run_entry, .context = &entries[e]};
    }
    time_in_turn(trials, turns, ENTRIES);
    columns(&e, "name n threads chunk ns:3");
    double pairs = n * (n - 1.0);
    for (int e = 0; e < ENTRIES; e++) {
        if (e < 3 * CHUNKS)
            row_begin("%s_%d", kinds[e / CHUNKS].name,
                      entries[e].chunk);
        else
            row_begin("blocks");
        row_cells("\t%u\t%d\t%d", n, question.threads,
                  entries[e].chunk);
        row_times(&turns[e].summary, pairs);
        row_end();
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
