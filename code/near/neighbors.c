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
    bool overflow, underflow;
    struct verdict verdict;
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
            job->overflow |= isinf(d2);
            job->underflow |=
                d2 < DBL_MIN &&
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
                job->verdict.wrong += check_lists(
                    &job->question, job->each ? INFINITY : job->reach2,
                    &lists, &job->verdict.first);
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
        job->verdict.wrong +=
            check_counts(&job->question, job->reach2, job->count,
                         &job->verdict.first);
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
        print_times(&job->question, job->algorithm_name, job->build_ns,
                    job->query_ns, counts.distances);
}

static void summarize_lists(const struct job *job, double ns)
{
    const double n = job->question.points.n;
    print_summary(job->options, &job->question, &(struct answers){0});
    if (job->each)
        printf("neighbors %" PRIu32 " each, the last at %.7g on "
               "average\n",
               job->each, job->last / n);
    else
        printf("neighbors %.7g on average within %.7g\n",
               job->found / n, job->options->distance);
    print_time(job->algorithm_name, ns, job->question.threads);
}

static void run_trials(struct job *job)
{
    const struct options *options = job->options;
    double *times = allocate(options->trials, sizeof *times);
    if (options->timing)
        print_times_header();
    progress_start("searching", 0);
    for (int trial = 0; trial < options->trials; trial++) {
        run_trial(job, trial == 0);
        times[trial] = job->build_ns + job->query_ns;
    }
    progress_stop();
    const struct summary summary = summarize(times, options->trials);
    free(times);
    warn_of_squares(job->overflow, job->underflow);
    if (options->check)
        report_check(options,
                     job->lists ? "lists of neighbors" : "counts",
                     job->verdict, job->question.points.n);
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
                      .verdict.first = NO_INDEX};
    job.lists =
        options->k ||
        (!options->counts &&
         (options->output || options->check || options->timing));
    job.overflow = isinf(job.reach2);
    job.underflow = options->distance > 0 && job.reach2 < DBL_MIN;
    if (!options->k)
        job.count = allocate(n, sizeof *job.count);
    if (options->output) {
        write_open(options->output);
        job.kind = table_kind(options->output);
    }
    run_trials(&job);
    if (options->output && job.verdict.wrong == 0)
        write_close();
    else
        write_abandon(); // wrong answers are not worth a file
    free(job.count);
    workspace_free(&workspace);
    points_free(&points);
    return job.verdict.wrong ? 1 : 0;
}
