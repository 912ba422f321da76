// Which part of the triangle's pairs falls to each thread, under static
// schedules with smaller and larger chunks. Nothing is timed: a static
// schedule depends on the numbers of rows and threads only.
//     load [POINTS [THREADS]]
#include "common/experiment.h"

static void weigh(uint32_t n, int threads, uint64_t *pairs)
{
#pragma omp parallel num_threads(threads)
    {
#pragma omp single
        if (omp_get_num_threads() < threads)
            fail("expected %d threads, got %d", threads,
                 omp_get_num_threads());
        uint64_t mine = 0;
#pragma omp for schedule(runtime)
        for (uint32_t i = 0; i < n; i++)
            mine += n - 1 - i;
        pairs[omp_get_thread_num()] = mine;
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 8000, 4, MANY);
    uint32_t most = n / 4 < 1000 ? n / 4 : 1000; // a row at least
    int threads = parameter(&e, "THREADS", 10, 1, most);
    enum { KINDS = 3 };
    const int chunks[KINDS] = {0, n / (4 * threads), 1}; // 0: undivided
    uint64_t *pairs = take(threads * KINDS, sizeof *pairs);
    omp_set_dynamic(0);
    for (int kind = 0; kind < KINDS; kind++) {
        omp_set_schedule(omp_sched_static, chunks[kind]);
        weigh(n, threads, pairs + kind * threads);
    }
    print_header(&e, "name thread blocks quarters singles");
    double all = n * (n - 1.0) / 2;
    for (int t = 0; t < threads; t++)
        row("thread_%d\t%d\t%.4f\t%.4f\t%.4f", t + 1, t + 1,
            pairs[t] / all, pairs[threads + t] / all,
            pairs[2 * threads + t] / all);
}
