//> Find nearest and furthest neighbors
// The program near: gets points, has an algorithm of the book answer
// for all of them, and writes the answers, the times, or a summary.
#include "algorithms.h"
#include "ch09-row-spans/keep.h"
#include "common/clock.h"
#include "common/fail.h"
#include "near_check.h"
#include "near_help.h"
#include "near_options.h"
#include "near_progress.h"
#include "near_write.h"
#include <fcntl.h>
#include <float.h>
#include <inttypes.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __linux__
#include <sys/sysinfo.h>
#endif
#include <unistd.h>

//> Insist on an output
// A file opened while standard output or error is closed would take its
// place, and get what was meant for it.
static void insist_on_output(void)
{
    if (fcntl(STDERR_FILENO, F_GETFD) < 0)
        exit(2);
    if (fcntl(STDOUT_FILENO, F_GETFD) < 0)
        fail("cannot write standard output: it is closed");
}
//<

//> Refuse what no memory can hold
// A system that promises more than it has would end us without a word.
static double memory_there(void)
{
#ifdef __linux__
    struct sysinfo system;
    if (sysinfo(&system) == 0)
        return ((double)system.totalram + system.totalswap) *
               system.mem_unit;
#endif
    return INFINITY;
}

static void insist_on_memory(uint32_t n, unsigned answers)
{
    const double answer = sizeof(uint32_t) + sizeof(double);
    double needed = 2 * sizeof(double) * (double)n;
    needed += (answers & NEAREST ? answer : 0) * n;
    needed += (answers & FURTHEST ? answer : 0) * n;
    if (needed > memory_there())
        fail("%" PRIu32 " points and their answers take %.0f GB, and "
             "this machine has %.0f",
             n, needed / 1e9, memory_there() / 1e9);
}
//<

//> Get the points
static struct points get_points(const struct options *options,
                                unsigned answers)
{
    if (!options->file)
        insist_on_memory(options->n, answers);
    progress_start(options->file ? "reading" : "drawing points", 0);
    struct points points =
        options->file ? read_points(options->file, options->columns)
                      : generate(options->distribution, options->n,
                                 options->seed);
    progress_stop();
    if (points.n < 2)
        fail("%s: expected at least two points, found one, which has "
             "no neighbor",
             strcmp(options->file, "-") == 0 ? "standard input"
                                             : options->file);
    return points;
}
//<

//> Suggest a box that holds the points
// High, if it is above low, or else the next number that is.
static double above(double low, double high)
{
    high = high > low ? high : low + 1;
    return high > low ? high : nextafter(low, INFINITY);
}

static _Noreturn void refuse_box(struct points points, uint32_t i)
{
    double x0 = points.x[i], x1 = x0, y0 = points.y[i], y1 = y0;
    for (uint32_t j = 0; j < points.n; j++) {
        x0 = fmin(x0, points.x[j]);
        x1 = fmax(x1, points.x[j]);
        y0 = fmin(y0, points.y[j]);
        y1 = fmax(y1, points.y[j]);
    }
    x0 = floor(x0), x1 = above(x0, ceil(x1));
    y0 = floor(y0), y1 = above(y0, ceil(y1));
    if (!isfinite(x1 - x0) || !isfinite(y1 - y0))
        fail("the points are too far apart for a box that wraps "
             "around; scale the coordinates");
    fail("the point (%g, %g) lies outside the box that wraps around; "
         "name one that holds all points, such as --box "
         "%.17g,%.17g,%.17g,%.17g",
         points.x[i], points.y[i], x0, y0, x1, y1);
}
//<

//> Choose how many threads
// Threads with few points would spend their time waiting for each
// other.
static int threads_for(const struct options *options, uint32_t n)
{
    enum { POINTS_PER_THREAD = 2000 };
    if (options->threads)
        return options->threads;
    int most = omp_get_max_threads();
    uint32_t worth = (n - 1) / POINTS_PER_THREAD + 1;
    return worth < (uint32_t)most ? (int)worth : most;
}
//<

//> Set up the space
static struct space get_space(const struct options *options,
                              struct points points)
{
    static const double unit_square[4] = {0, 0, 1, 1};
    const double *box = options->has_box ? options->box : unit_square;
    if (options->geometry == WRAPAROUND)
        for (uint32_t i = 0; i < points.n; i++)
            if (points.x[i] < box[0] || points.x[i] > box[2] ||
                points.y[i] < box[1] || points.y[i] > box[3])
                refuse_box(points, i);
    return (struct space){options->geometry, box[2] - box[0],
                          box[3] - box[1]};
}
//<

//> Choose the algorithms
// One if it answers all that can be answered, else one for the nearest
// and one for the furthest.
struct plan {
    const struct algorithm *algorithms[2];
    int count;
    unsigned answers;     // that they give together
    struct summary ns[2]; // how long each took
};

static void plan_for(struct plan *plan,
                     const struct algorithm *algorithm)
{
    if (!algorithm || (plan->count && plan->algorithms[0] == algorithm))
        return;
    plan->algorithms[plan->count++] = algorithm;
    plan->answers |= algorithm->answers;
}

static struct plan make_plan(const struct options *options)
{
    struct plan plan = {0};
    enum geometry geometry = options->geometry;
    if (options->algorithm) {
        plan_for(&plan, options->algorithm);
    } else {
        plan_for(&plan, fastest_algorithm(geometry, NEAREST));
        plan_for(&plan, fastest_algorithm(geometry, FURTHEST));
    }
    return plan;
}
//<

//> Answer and take the time
static double answer_once(const struct algorithm *algorithm,
                          const struct question *question,
                          struct answers *answers, double *build_ns)
{
    answers->built_ns = 0;
    progress_start(algorithm->name, 0);
    int64_t start = clock_ns();
    algorithm->run(question, answers);
    int64_t end = clock_ns();
    progress_stop();
    *build_ns = answers->built_ns ? answers->built_ns - start : 0;
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
            answer_once(algorithm, question, answers, &build);
        if (options->timing)
            printf("%s\t%" PRIu32 "\t%d\t%.0f\t%.0f\t%.0f\t%" PRIu64
                   "\n",
                   algorithm->name, question->points.n,
                   question->threads, build, times[trial] - build,
                   times[trial], counts.distances);
    }
    struct summary summary = summarize(times, options->trials);
    free(times);
    return summary;
}
//<

//> Warn of squares out of range
// Whether the closest images are in different places.
static bool apart(const struct question *question, uint32_t i,
                  uint32_t j)
{
    struct points p = question->points;
    struct space space = question->space;
    double dx = fabs(p.x[i] - p.x[j]), dy = fabs(p.y[i] - p.y[j]);
    bool wraps = space.geometry == WRAPAROUND;
    return !(dx == 0 || (wraps && dx == space.width)) ||
           !(dy == 0 || (wraps && dy == space.height));
}

static void warn_of_range(const struct question *question,
                          const struct answers *answers)
{
    uint32_t *nearest = answers->nearest;
    bool over = false, under = false;
    for (uint32_t i = 0; i < question->points.n; i++) {
        over |= answers->furthest && isinf(answers->furthest2[i]);
        over |= nearest && isinf(answers->nearest2[i]);
        under |= nearest && answers->nearest2[i] < DBL_MIN &&
                 apart(question, i, nearest[i]);
    }
    if (over || under)
        fprintf(stderr,
                "near: warning: some points are too %s for their "
                "squared distance, which is taken as %s; scale the "
                "coordinates\n",
                over ? "far apart" : "close together",
                over ? "infinite" : "zero or nearly so");
}
//<

//> Report what the check found
static bool report_check(FILE *out, const char *kind,
                         struct verdict verdict, uint32_t n)
{
    if (verdict.wrong)
        fprintf(out,
                "check: %" PRIu32 " of %" PRIu32
                " %s neighbors are wrong, the first that of "
                "point %" PRIu32 "\n",
                verdict.wrong, n, kind, verdict.first);
    else
        fprintf(out, "check: all %" PRIu32 " %s neighbors are right\n",
                n, kind);
    return verdict.wrong == 0;
}

static bool check(const struct options *options,
                  const struct question *question,
                  const struct answers *answers)
{
    uint32_t n = question->points.n;
    bool busy = options->timing ||
                (options->output && strcmp(options->output, "-") == 0);
    FILE *out = busy ? stderr : stdout;
    struct verdicts found = check_answers(question, answers);
    bool right = true;
    if (answers->nearest)
        right &= report_check(out, "nearest", found.nearest, n);
    if (answers->furthest)
        right &= report_check(out, "furthest", found.furthest, n);
    return right;
}
//<

//> Sum the answers up
static void summarize_distances(const char *kind,
                                const double *distance2, uint32_t n)
{
    double sum = 0;
    for (uint32_t i = 0; i < n; i++)
        sum += sqrt(distance2[i]);
    printf("%-9s %.7g on average\n", kind, sum / n);
}

static void print_summary(const struct options *options,
                          const struct plan *plan,
                          const struct question *question,
                          const struct answers *answers)
{
    uint32_t n = question->points.n;
    printf("points    %" PRIu32 " %s%s\n", n,
           options->file ? "from " : options->distribution->name,
           options->file ? options->file : "");
    printf("geometry  %s\n",
           options->geometry == STANDARD ? "standard" : "wraparound");
    if (answers->nearest)
        summarize_distances("nearest", answers->nearest2, n);
    if (answers->furthest)
        summarize_distances("furthest", answers->furthest2, n);
    for (int k = 0; k < plan->count; k++)
        printf("time      %.3g s, %s, at most %d thread%s\n",
               1e-9 * plan->ns[k].median, plan->algorithms[k]->name,
               question->threads, question->threads > 1 ? "s" : "");
}
//<

//> Get points, answer, write
static int near(const struct options *options)
{
    struct plan plan = make_plan(options);
    struct points points = get_points(options, plan.answers);
    struct question question = {points, get_space(options, points),
                                threads_for(options, points.n)};
    struct answers answers = answers_for(points.n, plan.answers);
    if (options->output)
        write_open(options->output);
    if (options->timing)
        puts("algorithm\tn\tthreads\tbuild_ns\tquery_ns\ttotal_ns\t"
             "distances");
    for (int k = 0; k < plan.count; k++)
        plan.ns[k] =
            answer(plan.algorithms[k], options, &question, &answers);
    warn_of_range(&question, &answers);

    bool right = !options->check || check(options, &question, &answers);
    if (options->output && right)
        write_answers(points, &answers);
    else
        write_abandon(); // wrong answers are not worth a file
    if (!options->output && !options->timing)
        print_summary(options, &plan, &question, &answers);
    answers_free(&answers);
    points_free(&points);
    return right ? 0 : 1;
}
//<

int main(int argc, char **argv)
{
    fail_as("near");
    insist_on_output();
    struct options options = parse_options(argc, argv);
    if (options.trials > 1)
        memory_keep();
    int status = 0;
    if (options.help)
        print_help();
    else if (options.list)
        print_list();
    else
        status = near(&options);
    return status;
}
//<
