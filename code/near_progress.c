//> Show a sign of life
// See near_progress.h.
#include "near_progress.h"
#include "common/clock.h"
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <unistd.h>

static struct {
    pthread_t thread;
    bool running;
    const char *what;
    uint32_t rows;
    atomic_uint_fast32_t done;
    int64_t start;
} progress;

//> Write the line once a second
static void *show(void *unused)
{
    for (;;) {
        sleep(1); // where progress_stop can cancel us
        int64_t seconds = (clock_ns() - progress.start) / 1000000000;
        fprintf(stderr, "\r%s: %lld s", progress.what,
                (long long)seconds);
        if (progress.rows)
            fprintf(stderr, ", %.0f %%",
                    100.0 * progress.done / progress.rows);
    }
    return unused;
}
//<

//> Start and stop the line
void progress_start(const char *what, uint32_t rows)
{
    progress.what = what;
    progress.rows = rows;
    progress.done = 0;
    progress.start = clock_ns();
    progress.running =
        isatty(STDERR_FILENO) &&
        pthread_create(&progress.thread, NULL, show, NULL) == 0;
}

void progress_row(void)
{
    atomic_fetch_add_explicit(&progress.done, 1, memory_order_relaxed);
}

void progress_stop(void)
{
    if (!progress.running)
        return;
    pthread_cancel(progress.thread);
    pthread_join(progress.thread, NULL);
    progress.running = false;
    fprintf(stderr, "\r\033[K"); // clears the line
}
//<
//<
