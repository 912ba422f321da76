// For libFuzzer (`make fuzz`): any bytes are read as points by one
// thread and by three, from a file and from a pipe, and each time the
// points or the sentence must be the same. Built with short lines and
// stretches, so that small inputs have many, and for arrays of NumPy's
// (-DNPY) with their magic in front of the bytes.
#include "common/read_points.h"
#include "fuzz_escape.h"
#include <fcntl.h>
#include <math.h>
#include <stdbool.h>
#include <sys/mman.h>
#include <unistd.h>

// ---- one reading ---------------------------------------------------
struct outcome {
    struct points points; // of a reading that did not fail
    char sentence[4096];  // of one that did
};

static struct outcome read_with(const char *name,
                                struct columns columns, int threads)
{
    struct outcome outcome = {0};
    const int descriptor = dup(STDIN_FILENO); // that it will get
    close(descriptor);
    if (setjmp(run.back) == 0) {
        struct points points = read_points(name, columns, threads);
        return (struct outcome){points, ""};
    }
    close(descriptor);
    memcpy(outcome.sentence, run.sentence, sizeof run.sentence);
    release_all();
    return outcome;
}

static bool same_numbers(const double *left, const double *right,
                         uint32_t n)
{
    return n == 0 || memcmp(left, right, n * sizeof *left) == 0;
}

// Behind the name of the file.
static const char *what_is_wrong(const struct outcome *outcome)
{
    const char *colon = strchr(outcome->sentence, ':');
    return colon ? colon : outcome->sentence;
}

static void compare(struct outcome *left, struct outcome *right)
{
    uint32_t n = left->points.n;
    if (n != right->points.n ||
        strcmp(what_is_wrong(left), what_is_wrong(right)) != 0 ||
        !same_numbers(left->points.x, right->points.x, n) ||
        !same_numbers(left->points.y, right->points.y, n)) {
        fprintf(stderr, "%u points \"%s\", and %u points \"%s\"\n", n,
                left->sentence, right->points.n, right->sentence);
        abort();
    }
    for (uint32_t i = 0; i < n; i++)
        if (!isfinite(left->points.x[i]) ||
            !isfinite(left->points.y[i]))
            abort();
    points_free(&right->points);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    static const struct columns columns[] = {
        {0, 0}, {1, 2}, {2, 3}, {3, 1}};
    if (size == 0 || size > 60000) // a pipe holds 64 KB
        return 0;
    const struct columns chosen = columns[*data++ % 4];
    const int file = memfd_create("points", 0);
    int ends[2];
    if (file < 0 || pipe(ends) != 0)
        abort();
#ifdef NPY
    const char magic[] = "\x93NUMPY";
#else
    const char magic[] = "";
#endif
    for (int k = 0; k < 2; k++) {
        const int to = k ? ends[1] : file;
        if (write(to, magic, sizeof magic - 1) < 0 ||
            write(to, data, size - 1) < 0)
            abort();
    }
    close(ends[1]);
    char name[30];
    snprintf(name, sizeof name, "/proc/self/fd/%d", file);
    struct outcome one = read_with(name, chosen, 1);
    struct outcome three = read_with(name, chosen, 3);
    compare(&one, &three);
    snprintf(name, sizeof name, "/proc/self/fd/%d", ends[0]);
    struct outcome piped = read_with(name, chosen, 3);
    compare(&one, &piped);
    points_free(&one.points);
    close(file);
    close(ends[0]);
    return 0;
}
