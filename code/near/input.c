// Gets the points and checks what can be checked before the search:
// that there are two, that memory holds them, that the box does.
#include "near/input.h"
#include "common/fail.h"
#include "near/progress.h"
#include "near/threads.h"
#include <inttypes.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/sysinfo.h>
#endif
// A system that promises more than it has would end us without a word.
static void insist_on_memory(uint32_t n, unsigned answers)
{
    double there = INFINITY;
#ifdef __linux__
    struct sysinfo system;
    if (sysinfo(&system) == 0)
        there = ((double)system.totalram + system.totalswap) *
                system.mem_unit;
#endif
    const double answer = sizeof(uint32_t) + sizeof(double);
    double needed = 2 * sizeof(double) * (double)n;
    needed += (answers & NEAREST ? answer : 0) * n;
    needed += (answers & FURTHEST ? answer : 0) * n;
    if (needed > there)
        fail("%" PRIu32 " points and their answers take %.0f GB, and "
             "this machine has %.0f",
             n, needed / 1e9, there / 1e9);
}

// A line of a table with a point has four characters at least. What is
// no file, such as a pipe, is read by one thread.
static int threads_to_read(const struct options *options)
{
    struct stat file;
    const bool from_stdin = strcmp(options->file, "-") == 0;
    const int found = from_stdin ? fstat(STDIN_FILENO, &file)
                                 : stat(options->file, &file);
    return found == 0 && S_ISREG(file.st_mode)
               ? threads_for(options->threads, file.st_size / 4 + 1)
               : 1;
}

struct points get_points(const struct options *options,
                         unsigned answers)
{
    if (!options->file)
        insist_on_memory(options->n, answers);
    int threads = options->file ? threads_to_read(options) : 1;
    progress_start(options->file ? "reading" : "drawing points", 0);
    struct points points =
        options->file
            ? read_points(options->file, options->columns, threads)
            : generate(options->distribution, options->n,
                       options->seed);
    progress_stop();
    insist_on_memory(points.n, answers);
    if (points.n < 2)
        fail("%s: expected at least two points, found one, which has "
             "no neighbor",
             strcmp(options->file, "-") == 0 ? "standard input"
                                             : options->file);
    return points;
}

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

struct space get_space(const struct options *options,
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
