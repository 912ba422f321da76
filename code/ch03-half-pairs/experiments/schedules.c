// The triangular loop with private answers, its rows handed out under
// each of OpenMP's schedules with smaller and larger chunks.
//     schedules [POINTS [TRIALS]]
#include "ch03-half-pairs/private.h"
#include "common/experiment.h"

enum { CHUNKS = 6, KINDS = 3, SCHEDULES = KINDS * CHUNKS + 1 };

static const struct {
    const char *name;
    omp_sched_t kind;
} kinds[KINDS] = {{"static", omp_sched_static},
                  {"dynamic", omp_sched_dynamic},
                  {"guided", omp_sched_guided}};

// Chunks of 1, 4, 16, ... rows; the last schedule is static, undivided.
struct schedule {
    const struct question *question;
    struct answers *answers;
    omp_sched_t kind;
    int chunk;
    char name[20];
};

static void run_schedule(void *context)
{
    struct schedule *s = context;
    triangle_private(s->question, s->answers, s->kind, s->chunk);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 2000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    question.threads = omp_get_num_procs();
    struct answers *answers = new_answers(n, BOTH);
    struct schedule schedules[SCHEDULES];
    struct trial turns[SCHEDULES];
    for (int k = 0; k < SCHEDULES; k++) {
        struct schedule *s = &schedules[k];
        *s = (struct schedule){&question, answers, omp_sched_static, 0,
                               "blocks"};
        turns[k] = (struct trial){.work = run_schedule, .context = s};
        if (k == SCHEDULES - 1)
            break;
        s->kind = kinds[k / CHUNKS].kind;
        s->chunk = 1 << 2 * (k % CHUNKS);
        sprintf(s->name, "%s_%d", kinds[k / CHUNKS].name, s->chunk);
    }
    time_in_turn(trials, turns, SCHEDULES);
    print_header(&e, "name n threads chunk ns:3");
    for (int k = 0; k < SCHEDULES; k++)
        row_of_times(&turns[k], 1, n * (n - 1.0), "%s\t%u\t%d\t%d",
                     schedules[k].name, n, question.threads,
                     schedules[k].chunk);
}
