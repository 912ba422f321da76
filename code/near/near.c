// The program near: gets points, has an algorithm of the book answer
// for all of them, and writes the answers, the times, or a summary.
#include "algorithms.h"
#include "common/clock.h"
#include "common/fail.h"
#include "common/workspace.h"
#include "near/check.h"
#include "near/help.h"
#include "near/input.h"
#include "near/neighbors.h"
#include "near/options.h"
#include "near/progress.h"
#include "near/summary.h"
#include "near/table.h"
#include "near/threads.h"
#include "near/write.h"
#include <stdio.h>
#include <stdlib.h>

// One if it answers all that can be answered, else one for the nearest
// and one for the furthest.
struct plan {
    const struct algorithm *algorithms[2];
    int count;
    unsigned answers;              // that they give together
    struct summary ns[2];          // how long each took
    const char *algorithm_name[2]; // what each was called
};

static struct plan make_plan(const struct options *options)
{
    static const enum answer kinds[] = {NEAREST, FURTHEST};
    struct plan plan = {0};
    for (int k = 0; k < 2; k++) {
        const struct algorithm *algorithm =
            options->algorithm
                ? options->algorithm
                : fastest_algorithm(options->geometry, kinds[k]);
        if (algorithm && algorithm != plan.algorithms[0]) {
            plan.algorithms[plan.count++] = algorithm;
            plan.answers |= algorithm->answers;
        }
    }
    return plan;
}

static double answer_once(const struct algorithm *algorithm,
                          struct question question,
                          struct answers *answers, double *build_ns)
{
    progress_start(algorithm->name, 0);
    int64_t start = clock_ns(), built = start;
    question.built_ns = &built;
    algorithm->run(&question, answers);
    int64_t end = clock_ns();
    progress_stop();
    *build_ns = built - start;
    return end - start;
}

static struct summary answer(const struct algorithm *algorithm,
                             const struct options *options,
                             const struct question *question,
                             struct answers *answers)
{
    struct counts counts = {0};
    if (options->timing) {
        progress_start("counting", 0);
        counts = count_operations(algorithm, question, answers);
        progress_stop();
    }
    double *times = allocate(options->trials, sizeof *times);
    for (int trial = 0; trial < options->trials; trial++) {
        double build;
        times[trial] =
            answer_once(algorithm, *question, answers, &build);
        if (options->timing)
            print_times(question, *question->algorithm_name, build,
                        times[trial] - build, counts.distances);
    }
    struct summary summary = summarize(times, options->trials);
    free(times);
    return summary;
}

static bool check(const struct options *options,
                  const struct question *question,
                  const struct answers *answers)
{
    uint32_t n = question->points.n;
    struct verdicts found = check_answers(question, answers);
    bool right = true;
    if (answers->nearest)
        right &= report_check(options, "nearest neighbors",
                              found.nearest, n);
    if (answers->furthest)
        right &= report_check(options, "furthest neighbors",
                              found.furthest, n);
    return right;
}

static int near(const struct options *options)
{
    struct plan plan = make_plan(options);
    struct points points = get_points(options, plan.answers);
    struct workspace workspace = {0};
    struct question question = {points, get_space(options, points),
                                threads_for(options->threads, points.n),
                                .workspace = &workspace};
    struct answers answers = answers_for(points.n, plan.answers);
    if (options->output)
        write_open(options->output);
    if (options->timing)
        print_times_header();
    for (int k = 0; k < plan.count; k++) {
        plan.algorithm_name[k] = plan.algorithms[k]->name;
        question.algorithm_name = &plan.algorithm_name[k];
        plan.ns[k] =
            answer(plan.algorithms[k], options, &question, &answers);
    }
    warn_of_range(&question, &answers);

    bool right = !options->check || check(options, &question, &answers);
    if (options->output && right) {
        write_table(table_kind(options->output), &question, &answers);
        write_close();
    } else {
        write_abandon(); // wrong answers are not worth a file
    }
    if (!options->output && !options->timing) {
        print_summary(options, &question, &answers);
        for (int k = 0; k < plan.count; k++)
            print_time(plan.algorithm_name[k], plan.ns[k].median,
                       question.threads);
    }
    workspace_free(&workspace);
    answers_free(&answers);
    points_free(&points);
    return right ? 0 : 1;
}

int main(int argc, char **argv)
{
    fail_as("near");
    insist_on_output();
    reexec_with_passive_wait(argv);
    struct options options = parse_options(argc, argv);
    int status = 0;
    if (options.help)
        print_help();
    else if (options.list)
        print_list();
    else if (options.k || options.within)
        status = answer_neighbors(&options);
    else
        status = near(&options);
    return status;
}
