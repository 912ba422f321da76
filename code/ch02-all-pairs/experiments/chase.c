// Walks through memory so that each step has to wait for the one
// before: every line holds the number of the next, and all lines are on
// one cycle in random order. Prints nanoseconds a step for 64 to LINES
// lines, once packed together, and once on a page of their own each.
//     chase [LINES [STEPS [TRIALS]]]
#include "common/experiment.h"
#include <sys/mman.h>

enum { LINE = 64, PAGE = 4096 };

struct walk {
    char *memory;
    uint32_t steps;
    uint64_t at; // where the walk stands
};

// Line k, packed, or on page k; there the lines differ in their place,
// so that they do not compete for the same places of a cache.
static uint64_t place(uint64_t k, bool apart)
{
    return apart ? k * PAGE + k % (PAGE / LINE) * LINE : k * LINE;
}

// Writes one cycle through all lines (Sattolo 1986).
static void link_lines(char *memory, uint32_t *order, uint32_t lines,
                       bool apart)
{
    struct random random = {1};
    for (uint32_t k = 0; k < lines; k++)
        order[k] = k;
    for (uint32_t k = lines - 1; k > 0; k--) {
        uint32_t j = (uint32_t)(random_bits(&random) % k);
        uint32_t kept = order[k];
        order[k] = order[j];
        order[j] = kept;
    }
    for (uint32_t k = 0; k < lines; k++)
        *(uint64_t *)(memory + place(k, apart)) =
            place(order[k], apart);
}

static void step_on(void *context)
{
    struct walk *walk = context;
    uint64_t at = walk->at;
    for (uint32_t step = 0; step < walk->steps; step++)
        at = *(uint64_t *)(walk->memory + at);
    walk->at = at;
}

static char *small_pages(uint64_t bytes)
{
    char *memory = mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        fail("not enough memory for %ju bytes", (uintmax_t)bytes);
#ifdef MADV_NOHUGEPAGE
    madvise(memory, bytes, MADV_NOHUGEPAGE);
#endif
    return memory;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "LINES", 1 << 13, 64, MANY);
    uint32_t steps = parameter(&e, "STEPS", 1 << 16, 1, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    char *memory = small_pages((uint64_t)most * PAGE + PAGE);
    uint32_t *order = take(most, sizeof *order);
    print_header(&e, "name lines kilobytes packed:3 apart:3");
    for (uint32_t lines = 64; lines <= most; lines *= 2) {
        row_begin("lines_%u\t%u\t%u", lines, lines, lines / 16);
        for (int apart = 0; apart < 2; apart++) {
            link_lines(memory, order, lines, apart);
            struct walk walk = {memory, steps, 0};
            struct summary summary =
                time_trials(trials, step_on, &walk);
            row_times(&summary, steps);
        }
        row_end();
    }
}
