// A thread of its own wakes once a second and writes a line over the
// last one; what works only adds to a counter.
#include "near/progress.h"
#include "common/clock.h"
#include <errno.h>
#include <inttypes.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

static struct {
    pthread_t thread;
    pthread_mutex_t lock; // of running
    pthread_cond_t stop;
    bool running;
    const char *what;
    uint32_t rows;
    atomic_uint_fast32_t done;
    int64_t start;
} progress = {.lock = PTHREAD_MUTEX_INITIALIZER,
              .stop = PTHREAD_COND_INITIALIZER};
static void write_line(void)
{
    int64_t seconds = (clock_ns() - progress.start) / 1000000000;
    fprintf(stderr, "\033[K%s: %" PRId64 " s", progress.what, seconds);
    if (progress.rows)
        fprintf(stderr, ", %.0f %%",
                100.0 * progress.done / progress.rows);
    fprintf(stderr, "\r");
}

static void *show(void *unused)
{
    pthread_mutex_lock(&progress.lock);
    while (progress.running) {
        struct timespec next;
        clock_gettime(CLOCK_REALTIME, &next);
        next.tv_sec++;
        if (pthread_cond_timedwait(&progress.stop, &progress.lock,
                                   &next) == ETIMEDOUT)
            write_line();
    }
    pthread_mutex_unlock(&progress.lock);
    return unused;
}

void progress_start(const char *what, uint32_t rows)
{
    progress.what = what;
    progress.rows = rows;
    progress.done = 0;
    progress.start = clock_ns();
    progress.running = isatty(STDERR_FILENO);
    if (progress.running &&
        pthread_create(&progress.thread, NULL, show, NULL) != 0)
        progress.running = false; // then without it
}

void progress_rows(uint32_t count)
{
    atomic_fetch_add_explicit(&progress.done, count,
                              memory_order_relaxed);
}

void progress_stop(void)
{
    if (!progress.running)
        return;
    pthread_mutex_lock(&progress.lock);
    progress.running = false;
    pthread_cond_signal(&progress.stop);
    pthread_mutex_unlock(&progress.lock);
    pthread_join(progress.thread, NULL);
    fprintf(stderr, "\033[K"); // clears the line
}
