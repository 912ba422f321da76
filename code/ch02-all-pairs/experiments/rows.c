// Wraps a search of some rows into a trial. The work of a trial is one
// call, for a question that the driver keeps.
#include "ch02-all-pairs/experiments/rows.h"

struct run {
    rows_function *function;
    struct question question;
    struct answers *answers;
    uint32_t rows;
};

static void run_rows(void *context)
{
    const struct run *run = context;
    run->function(&run->question, run->answers, 0, run->rows);
}

struct trial rows_trial(rows_function *function,
                        const struct question *question,
                        struct answers *answers, uint32_t rows)
{
    struct run *run = take(1, sizeof *run);
    *run = (struct run){function, *question, answers, rows};
    return (struct trial){.work = run_rows, .context = run};
}

struct question question_in(bool quarter, enum geometry geometry,
                            uint32_t n)
{
    struct question question = uniform_question(geometry, n, 1);
    for (uint32_t i = 0; quarter && i < n; i++) {
        question.points.x[i] /= 4;
        question.points.y[i] /= 4;
    }
    return question;
}
