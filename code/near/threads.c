// Decides how many threads work, and tries whether they can be had,
// before any work is done.
#include "near/threads.h"
#include "common/fail.h"
#include <omp.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

void let_waiting_threads_sleep(char **argv)
{
    if (getenv("OMP_WAIT_POLICY"))
        return;
    setenv("OMP_WAIT_POLICY", "passive", 1);
    execv("/proc/self/exe", argv); // it only returns where it fails
}

// An OpenMP library that cannot start its threads ends the program in
// its own way. So a copy of this program tries it first.
static int can_start(int threads)
{
    pid_t copy = fork();
    if (copy == 0) {
        int started = 0;
        close(STDERR_FILENO);
#pragma omp parallel num_threads(threads) reduction(+ : started)
        started++;
        _exit(started < 1);
    }
    int status = 0;
    return copy > 0 && waitpid(copy, &status, 0) == copy && status == 0;
}

// Threads with few points would spend their time waiting for each
// other.
int threads_for(int wanted, uint32_t n)
{
    enum { POINTS_PER_THREAD = 2000 };
    int threads = wanted;
    if (!wanted) {
        uint32_t worth = (n - 1) / POINTS_PER_THREAD + 1;
        threads = omp_get_max_threads();
        threads = threads < MAX_THREADS ? threads : MAX_THREADS;
        threads = worth < (uint32_t)threads ? (int)worth : threads;
    }
    if (threads > 1 && !can_start(threads))
        fail("cannot start %d threads; fewer may do (-t)", threads);
    return threads;
}
