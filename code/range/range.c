// The program range: gets points, builds a structure of chapter 12,
// asks it about boxes or places, and writes the answers, the times, or
// a summary.
#include "common/clock.h"
#include "common/fail.h"
#include "near/progress.h"
#include "near/threads.h"
#include "near/write.h"
#include "range/answer.h"
#include "range/help.h"
#include "range/output.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct times {
    double build_ns, query_ns;
};

// Answers all queries. Where the answers are wanted, they are checked
// and written, which is not timed; says how many are wrong.
static uint32_t answer_all(const struct task *task, bool write,
                           struct totals *totals, double *ns)
{
    const bool check = task->options->check && write;
    const bool out = task->options->output && write;
    const uint32_t count = task->queries.count;
    struct answer answer[BATCH];
    uint32_t wrong = 0;
    progress_start(task->structure->name, count);
    for (uint64_t first = 0; first < count; first += BATCH) {
        const uint32_t some =
            count - first < BATCH ? count - first : BATCH;
        const int64_t start = clock_ns();
        answer_batch(task, first, first + some,
                     check || out ? answer : NULL, totals);
        *ns += clock_ns() - start;
        if (check)
            wrong += count_wrong(task, first, answer, some);
        if (out)
            write_answers(task, first, answer, some);
        if (check || out)
            answers_release(answer, some);
        progress_rows(some);
    }
    progress_stop();
    return wrong;
}

static void print_timing(const struct task *task, struct times times,
                         const struct totals *totals)
{
    printf("%s\t%" PRIu32 "\t%d\t%d\t%.0f\t%.0f\t%.0f\t%zu\t%" PRIu64
           "\t%" PRIu64 "\t%" PRIu64 "\n",
           task->structure->name, task->points.n, task->points.d,
           task->threads, times.build_ns, times.query_ns,
           times.build_ns + times.query_ns,
           task->structure->bytes(task->built), totals->found,
           totals->tested, totals->steps);
}

static void print_summary(const struct task *task, struct times times,
                          const struct totals *totals)
{
    const double count = task->queries.count;
    printf("points    %" PRIu32 " in %d dimension%s\n", task->points.n,
           task->points.d, task->points.d > 1 ? "s" : "");
    printf("queries   %" PRIu32 ", each finds %.6g on average\n",
           task->queries.count, totals->found / count);
    printf("build     %.3g s, %s, %.3g bytes a point\n",
           1e-9 * times.build_ns, task->structure->name,
           (double)task->structure->bytes(task->built) /
               task->points.n);
    printf("query     %.3g s, %.3g us each, at most %d thread%s\n",
           1e-9 * times.query_ns, 1e-3 * times.query_ns / count,
           task->threads, task->threads > 1 ? "s" : "");
    printf("work      %.6g points looked at a query, %.6g steps\n",
           totals->tested / count, totals->steps / count);
}

// Builds and asks; the first trial gives the answers.
static uint32_t run_trial(struct task *task, int trial)
{
    const struct options *options = task->options;
    struct totals totals = {0};
    struct times times = {0};
    const int64_t start = clock_ns();
    progress_start("building", 0);
    void *built = task->structure->build(&task->points, task->threads);
    progress_stop();
    times.build_ns = clock_ns() - start;
    task->built = built;
    const uint32_t wrong =
        answer_all(task, trial == 0, &totals, &times.query_ns);
    if (options->timing)
        print_timing(task, times, &totals);
    else if (!options->output && trial == options->trials - 1)
        print_summary(task, times, &totals);
    task->structure->discard(built);
    return wrong;
}

static bool report_check(const struct task *task, uint32_t wrong)
{
    const struct options *o = task->options;
    const bool busy =
        o->timing || (o->output && strcmp(o->output, "-") == 0);
    FILE *out = busy ? stderr : stdout;
    const uint32_t count = task->queries.count;
    if (wrong)
        fprintf(out,
                "check: %" PRIu32 " of %" PRIu32 " answers are wrong\n",
                wrong, count);
    else
        fprintf(out, "check: all %" PRIu32 " answers are right\n",
                count);
    return wrong == 0;
}

static int range(const struct options *options)
{
    struct task task = {.options = options,
                        .points = get_point_set(options),
                        .structure = options->structure};
    task.queries = get_queries(options, &task.points);
    task.threads = threads_for(options->threads, task.points.n);
    if (options->output) {
        write_open(options->output);
        write_head(&task);
    }
    if (options->timing)
        puts("structure\tn\td\tthreads\tbuild_ns\tquery_ns\ttotal_ns\t"
             "bytes\tfound\ttested\tsteps");
    uint32_t wrong = 0;
    for (int trial = 0; trial < options->trials; trial++)
        wrong += run_trial(&task, trial);
    const bool right = !options->check || report_check(&task, wrong);
    if (options->output && right)
        write_close();
    else
        write_abandon(); // wrong answers are not worth a file
    free(task.queries.value);
    point_set_free(&task.points);
    return right ? 0 : 1;
}

int main(int argc, char **argv)
{
    fail_as("range");
    insist_on_output();
    reexec_with_passive_wait(argv);
    struct options options = parse_range_options(argc, argv);
    int status = 0;
    if (options.help)
        print_range_help();
    else if (options.list)
        print_range_list();
    else
        status = range(&options);
    return status;
}
