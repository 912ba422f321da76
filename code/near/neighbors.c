// Searches block by block: as many lists as fit into some memory are
// found, checked, written, and forgotten.
#include "near/neighbors.h"
#include "ch12-range-queries/plane_neighbors.h"
#include "common/allocate.h"
#include "common/clock.h"
#include "common/min_max.h"
#include "common/workspace.h"
#include "near/input.h"
#include "near/lists.h"
#include "near/progress.h"
#include "near/summary.h"
#include "near/threads.h"
#include "near/write.h"
#include <float.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Neighbors that are held at a time, of 12 bytes each; but a list is
// held as a whole.
enum { HELD = 1 << 24 };

struct job {
    const struct options *options;
    struct question question;
    double reach2;
    uint32_t each;   // neighbors of each point; 0: all within reach
    uint32_t *count; // within reach
    bool lists;      // whether lists are made
    enum table_kind kind;

    // What has come out.
    uint64_t found;
    double last; // sum of the distances to the last of each list
    bool over, under;
    uint32_t wrong, first_wrong;
    double build_ns, query_ns;
    const char *algorithm_name;
};

static uint64_t length_of(const struct job *job, uint32_t i)
{
    return job->each ? job->each : job->count[i];
}

// The next block, from its first on; start has room for all.
static void choose_block(const struct job *job,
                         struct neighbor_lists *lists, uint64_t *start)
{
    const uint32_t n = job->question.points.n;
    uint64_t held = 0;
    lists->each = job->each;
    lists->start = job->each ? NULL : start;
    lists->last = lists->first;
    while (lists->last < n &&
           (held == 0 || held + length_of(job, lists->last) <= HELD)) {
        if (lists->start)
            start[lists->last - lists->first] = held;
        held += length_of(job, lists->last++);
    }
    if (lists->start)
        start[lists->last - lists->first] = held;
    lists->index = allocate(held, sizeof *lists->index);
    lists->distance2 = allocate(held, sizeof *lists->distance2);
}

// What a user should know of the lists.
static void sum_up(struct job *job, const struct neighbor_lists *lists)
{
    for (uint32_t i = lists->first; i < lists->last; i++) {
        const uint64_t end = list_start(lists, i + 1);
        for (uint64_t k = list_start(lists, i); k < end; k++) {
            const double d2 = lists->distance2[k];
            job->over |= isinf(d2);
            job->under |= d2 < DBL_MIN &&
                          are_apart(&job->question, i, lists->index[k]);
        }
        if (end > list_start(lists, i))
            job->last += sqrt(lists->distance2[end - 1]);
    }
}

static void fill_all(struct job *job, const struct plane_index *index,
                     bool first, struct counts *counts)
{
    const uint32_t n = job->question.points.n;
    uint64_t *start =
        job->each ? NULL : allocate((size_t)n + 1, sizeof *start);
    struct neighbor_lists lists = {0};
    for (; lists.first < n; lists.first = lists.last) {
        choose_block(job, &lists, start);
        const int64_t begin = clock_ns();
        fill_plane_lists(index, job->each ? INFINITY : job->reach2,
                         &lists, counts);
        job->query_ns += clock_ns() - begin;
        if (first) {
            sum_up(job, &lists);
            if (job->options->check)
                job->wrong += check_lists(
                    &job->question, job->each ? INFINITY : job->reach2,
                    &lists, &job->first_wrong);
            if (job->options->output)
                write_lists(job->kind, &lists, job->question.threads);
        }
        free(lists.index);
        free(lists.distance2);
    }
    free(start);
}

static void count_all(struct job *job, const struct plane_index *index,
                      bool first, struct counts *counts)
{
    const uint32_t n = job->question.points.n;
    const int64_t begin = clock_ns();
    count_plane_within(index, job->reach2, job->count, counts);
    job->query_ns += clock_ns() - begin;
    job->found = 0;
    for (uint32_t i = 0; i < n; i++)
        job->found += job->count[i];
    if (first && job->options->check)
        job->wrong += check_counts(&job->question, job->reach2,
                                   job->count, &job->first_wrong);
}

// The first trial gives the answers.
static void run_trial(struct job *job, bool first)
{
    const struct options *options = job->options;
    struct workspace *workspace = job->question.workspace;
    struct counts counts = {0};
    const struct mark mark = workspace_mark(workspace);
    const int64_t begin = clock_ns();
    const struct plane_index index =
        plane_index_make(&job->question, workspace);
    job->build_ns = clock_ns() - begin;
    job->query_ns = 0;
    job->algorithm_name = index.is_even ? "one-grid" : "pieces";
    if (!job->each)
        count_all(job, &index, first, &counts);
    if (first && options->output)
        write_lists_head(job->kind, options->counts,
                         options->counts ? job->question.points.n
                                         : job->found);
    if (job->lists)
        fill_all(job, &index, first, &counts);
    else if (first && options->output)
        write_counts(job->kind, job->count, job->question.points.n);
    workspace_release(workspace, mark);
    if (options->timing)
        printf("%s\t%" PRIu32 "\t%d\t%.0f\t%.0f\t%.0f\t%" PRIu64 "\n",
               job->algorithm_name, job->question.points.n,
               job->question.threads, job->build_ns, job->query_ns,
               job->build_ns + job->query_ns, counts.distances);
}

static void report_check(const struct job *job)
{
    const struct options *o = job->options;
    const bool busy =
        o->timing || (o->output && strcmp(o->output, "-") == 0);
    FILE *out = busy ? stderr : stdout;
    const uint32_t n = job->question.points.n;
    const char *what = job->lists ? "lists of neighbors" : "counts";
    if (job->wrong)
        fprintf(out,
                "check: %" PRIu32 " of %" PRIu32
                " %s are wrong, the first that of point %" PRIu32 "\n",
                job->wrong, n, what, job->first_wrong);
    else
        fprintf(out, "check: all %" PRIu32 " %s are right\n", n, what);
}

static void summarize_lists(const struct job *job, double ns)
{
    const double n = job->question.points.n;
    const int threads = job->question.threads;
    print_summary(job->options, &job->question, &(struct answers){0});
    if (job->each)
        printf("neighbors %" PRIu32 " each, the last at %.7g on "
               "average\n",
               job->each, job->last / n);
    else
        printf("neighbors %.7g on average within %.7g\n",
               job->found / n, job->options->distance);
    printf("time      %.3g s, %s, at most %d thread%s\n", 1e-9 * ns,
           job->algorithm_name, threads, threads > 1 ? "s" : "");
}

static void run_trials(struct job *job)
{
    const struct options *options = job->options;
    double *times = allocate(options->trials, sizeof *times);
    if (options->timing)
        puts("algorithm\tn\tthreads\tbuild_ns\tquery_ns\ttotal_ns\t"
             "distances");
    progress_start("searching", 0);
    for (int trial = 0; trial < options->trials; trial++) {
        run_trial(job, trial == 0);
        times[trial] = job->build_ns + job->query_ns;
    }
    progress_stop();
    const struct summary summary = summarize(times, options->trials);
    free(times);
    warn_of_squares(job->over, job->under);
    if (options->check)
        report_check(job);
    if (!options->output && !options->timing)
        summarize_lists(job, summary.median);
}

int answer_neighbors(const struct options *options)
{
    struct points points = get_points(options, 0);
    struct workspace workspace = {0};
    const uint32_t n = points.n;
    struct job job = {.options = options,
                      .question = {points, get_space(options, points),
                                   threads_for(options->threads, n),
                                   .workspace = &workspace},
                      .reach2 = options->distance * options->distance,
                      .each = MIN(options->k, n - 1),
                      .found = (uint64_t)n * MIN(options->k, n - 1),
                      .first_wrong = NO_INDEX};
    job.lists =
        options->k ||
        (!options->counts &&
         (options->output || options->check || options->timing));
    job.over = isinf(job.reach2);
    job.under = options->distance > 0 && job.reach2 < DBL_MIN;
    if (!options->k)
        job.count = allocate(n, sizeof *job.count);
    if (options->output) {
        write_open(options->output);
        job.kind = table_kind(options->output);
    }
    run_trials(&job);
    if (options->output && job.wrong == 0)
        write_close();
    else
        write_abandon(); // wrong answers are not worth a file
    free(job.count);
    workspace_free(&workspace);
    points_free(&points);
    return job.wrong ? 1 : 0;
}
