// The points go to Python in files, and so do the answers come back;
// Python has the clock, so that files cost nothing.
#include "peers/range_scipy.h"
#include "common/fail.h"
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SCRIPT "\"${PYTHON:-python3}\" code/peers/range_scipy.py"

bool scipy_is_there(void)
{
    if (system(SCRIPT " 2>/dev/null") == 0)
        return true;
    fprintf(stderr, "no Python with SciPy, whose rows are left out; "
                    "./setup peers installs it\n");
    return false;
}

// What a program in Python and this one hand each other.
struct exchange {
    char folder[32], points[48], nearest2[48];
};

static struct exchange exchange_open(void)
{
    struct exchange e = {"/tmp/ranges-XXXXXX"};
    if (!mkdtemp(e.folder))
        fail("cannot make a folder in /tmp: %s", strerror(errno));
    snprintf(e.points, sizeof e.points, "%s/points", e.folder);
    snprintf(e.nearest2, sizeof e.nearest2, "%s/nearest2", e.folder);
    return e;
}

static void exchange_close(const struct exchange *e)
{
    unlink(e->points);
    unlink(e->nearest2);
    rmdir(e->folder);
}

static bool put(const char *path, const double *from, size_t count)
{
    FILE *file = fopen(path, "wb");
    bool put = file && fwrite(from, sizeof *from, count, file) == count;
    return file && fclose(file) == 0 && put;
}

static bool get(const char *path, double *to, size_t count)
{
    FILE *file = fopen(path, "rb");
    bool got = file && fread(to, sizeof *to, count, file) == count;
    return file && fclose(file) == 0 && got;
}

// Whether Python has answered.
static bool ask_python(const struct exchange *e,
                       const struct range_scene *scene,
                       struct range_run *run)
{
    char command[200];
    snprintf(command, sizeof command, SCRIPT " %s %d %d %.17g",
             e->folder, scene->points.d, NEIGHBORS_WANTED,
             scene->distance);
    FILE *python = popen(command, "r");
    const int numbers =
        python ? fscanf(python, "%lf %lf %lf %" SCNu64, &run->ns[BUILD],
                        &run->ns[NEAREST_ONES], &run->ns[ALL_WITHIN],
                        &run->within)
               : 0;
    return python && pclose(python) == 0 && numbers == 4;
}

struct range_run run_scipy(struct range_scene *scene)
{
    const uint32_t n = scene->points.n;
    struct range_run run = {0};
    const struct exchange e = exchange_open();
    const bool answered =
        put(e.points, scene->row, (size_t)n * scene->points.d) &&
        ask_python(&e, scene, &run) &&
        get(e.nearest2, scene->nearest2, (size_t)n * NEIGHBORS_WANTED);
    exchange_close(&e);
    if (!answered)
        fail("SciPy has not answered about %u points", n);
    run.ns[NEAREST_ONES] /= n;
    run.ns[ALL_WITHIN] /= n;
    return run;
}
