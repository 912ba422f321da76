// Two threads, each with a counter of its own that only it changes. The
// counters lie 8 to 256 bytes apart: where they share a cache line, the
// line has to travel.
//     false-sharing [STEPS [TRIALS]]
#include "common/experiment.h"
#include <stdatomic.h>

enum { THREADS = 2, DISTANCES = 6 }; // 8, 16, ... 256 bytes

struct counting {
    _Atomic uint64_t *counters;
    uint32_t apart; // in counters
    uint32_t steps;
};

// Atomic, so that every step is a load and a store; relaxed, so that it
// is no more than that.
static void count_up(void *context)
{
    const struct counting *counting = context;
#pragma omp parallel num_threads(THREADS)
    {
        _Atomic uint64_t *mine =
            counting->counters +
            omp_get_thread_num() * (size_t)counting->apart;
        for (uint32_t step = 0; step < counting->steps; step++)
            atomic_store_explicit(
                mine,
                atomic_load_explicit(mine, memory_order_relaxed) + 1,
                memory_order_relaxed);
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t steps = parameter(&e, "STEPS", 1000000, 1, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    _Atomic uint64_t *counters =
        take(THREADS << DISTANCES, sizeof *counters);
    struct counting apart[DISTANCES];
    struct trial turns[DISTANCES];
    for (int d = 0; d < DISTANCES; d++) {
        apart[d] = (struct counting){counters, 1u << d, steps};
        turns[d] =
            (struct trial){.work = count_up, .context = &apart[d]};
    }
    time_in_turn(trials, turns, DISTANCES);
    print_header(&e, "name bytes ns:3");
    for (int d = 0; d < DISTANCES; d++)
        row_of_times(&turns[d], 1, steps, "apart_%d\t%d", 8 << d,
                     8 << d);
}
