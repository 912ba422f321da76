//> Add up the counts of threads
// A few atomic additions for each thread or chunk of work: cheap beside
// what they count, and nothing at all where nothing is counted.
#include "common/count.h"
#include <stddef.h>

static void add(uint64_t *total, uint64_t amount)
{
#pragma omp atomic
    *total += amount;
}

void counts_add(struct counts *total, const struct counts *mine)
{
    if (!total)
        return;
    add(&total->distances, mine->distances);
    add(&total->cells, mine->cells);
    add(&total->tasks, mine->tasks);
    add(&total->collisions, mine->collisions);
    add(&total->exact, mine->exact);
}
//<
