// Looks at all answers once more, for what a user should know of them:
// squares beyond the range of a double, and the mean distances.
#include "near/summary.h"
#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

// Whether the closest images are in different places.
bool are_apart(const struct question *question, uint32_t i, uint32_t j)
{
    struct points p = question->points;
    struct space space = question->space;
    double dx = fabs(p.x[i] - p.x[j]), dy = fabs(p.y[i] - p.y[j]);
    bool wraps = space.geometry == WRAPAROUND;
    return !(dx == 0 || (wraps && dx == space.width)) ||
           !(dy == 0 || (wraps && dy == space.height));
}

void warn_of_range(const struct question *question,
                   const struct answers *answers)
{
    uint32_t *nearest = answers->nearest;
    bool overflow = false, underflow = false;
    for (uint32_t i = 0; i < question->points.n; i++) {
        overflow |= answers->furthest && isinf(answers->furthest2[i]);
        overflow |= nearest && isinf(answers->nearest2[i]);
        underflow |= nearest && answers->nearest2[i] < DBL_MIN &&
                     are_apart(question, i, nearest[i]);
    }
    warn_of_squares(overflow, underflow);
}

void warn_of_squares(bool overflow, bool underflow)
{
    if (overflow || underflow)
        fprintf(stderr,
                "near: warning: some points are too %s for their "
                "squared distance, which is taken as %s; scale the "
                "coordinates\n",
                overflow ? "far apart" : "close together",
                overflow ? "infinite" : "zero or nearly so");
}

static void summarize_distances(const char *kind,
                                const double *distance2, uint32_t n)
{
    double sum = 0;
    for (uint32_t i = 0; i < n; i++)
        sum += sqrt(distance2[i]);
    printf("%-9s %.7g on average\n", kind, sum / n);
}

void print_summary(const struct options *options,
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
}

bool report_check(const struct options *options, const char *what,
                  struct verdict verdict, uint32_t n)
{
    const char *output = options->output;
    const bool table =
        options->timing || (output && strcmp(output, "-") == 0);
    FILE *out = table ? stderr : stdout;
    if (verdict.wrong)
        fprintf(out,
                "check: %" PRIu32 " of %" PRIu32
                " %s are wrong, the first that of point %" PRIu32 "\n",
                verdict.wrong, n, what, verdict.first);
    else
        fprintf(out, "check: all %" PRIu32 " %s are right\n", n, what);
    return verdict.wrong == 0;
}

void print_times_header(void)
{
    puts("algorithm\tn\tthreads\tbuild_ns\tquery_ns\ttotal_ns\t"
         "distances");
}

void print_times(const struct question *question,
                 const char *algorithm_name, double build_ns,
                 double query_ns, uint64_t distances)
{
    printf("%s\t%" PRIu32 "\t%d\t%.0f\t%.0f\t%.0f\t%" PRIu64 "\n",
           algorithm_name, question->points.n, question->threads,
           build_ns, query_ns, build_ns + query_ns, distances);
}

void print_time(const char *algorithm_name, double ns, int threads)
{
    printf("time      %.3g s, %s, at most %d thread%s\n", 1e-9 * ns,
           algorithm_name, threads, threads > 1 ? "s" : "");
}
