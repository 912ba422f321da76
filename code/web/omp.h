// One thread, for where there is no OpenMP.
#pragma once

typedef enum {
    omp_sched_static = 1,
    omp_sched_dynamic,
    omp_sched_guided
} omp_sched_t;

static inline int omp_get_thread_num(void)
{
    return 0;
}
static inline int omp_get_num_threads(void)
{
    return 1;
}
static inline int omp_get_max_threads(void)
{
    return 1;
}
static inline int omp_get_num_procs(void)
{
    return 1;
}
static inline void omp_set_schedule(omp_sched_t kind, int chunk)
{
    (void)kind, (void)chunk;
}
