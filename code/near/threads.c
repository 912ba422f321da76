// Decides how many threads work, and tries whether they can be had,
// before any work is done.
#include "near/threads.h"
#include "common/fail.h"
#include <omp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

void reexec_with_passive_wait(char **argv)
{
    if (getenv("OMP_WAIT_POLICY"))
        return;
    setenv("OMP_WAIT_POLICY", "passive", 1);
    setenv("GOMP_SPINCOUNT", "1000", 0); // some 25 microseconds
    execv("/proc/self/exe", argv); // it only returns where it fails
}

// An OpenMP library that cannot start its threads ends the program in
// its own way. So a copy of this program tries it first, as long as the
// program has no other threads, which a copy would miss.
static bool can_start(int threads)
{
    static int started = 1;
    pid_t copy = threads > started ? fork() : -1;
    if (copy == 0) {
        int there = 0;
        close(STDERR_FILENO);
#pragma omp parallel num_threads(threads) reduction(+ : there)
        there++;
        _exit(there < 1);
    }
    int status = 0;
    if (copy > 0 && waitpid(copy, &status, 0) == copy && status == 0)
        started = threads;
    return threads <= started;
}

// Threads with few points would spend their time waiting for each
// other.
int threads_for(int wanted, uint64_t n)
{
    enum { POINTS_PER_THREAD = 2000 };
    int threads = wanted;
    if (!wanted) {
        uint64_t worth = (n - 1) / POINTS_PER_THREAD + 1;
        threads = omp_get_max_threads();
        threads = threads < MAX_THREADS ? threads : MAX_THREADS;
        threads = worth < (uint64_t)threads ? (int)worth : threads;
    }
    if (!can_start(threads))
        fail("cannot start %d threads; fewer may do (-t)", threads);
    return threads;
}
