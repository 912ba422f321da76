//> Time the sorts
// Sorts points of every kind named, or uniform ones, by cell, with
// counts that threads share and counts of their own, on one thread and
// on all processors. The kind "memory" shows what the machine needs for
// as much memory as the sort by bands writes: to get it, and to copy
// it.
//
//     sorts [POINTS [TRIALS [KIND...]]]
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/sorted.h"
#include "ch05-collisions/bands.h"
#include "ch05-collisions/shared.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/report.h"
#include <omp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

//> Name the sorts
static const struct {
    const char *name;
    cell_sort *sort, *before; // the sort that has run just before
} sorts[] = {
    {"serial", cells_sort_alone, cells_sort_alone},
    {"atomic", cells_sort_atomic, cells_sort_atomic},
    {"private", cells_sort_private, cells_sort_private},
    {"bands", cells_sort_threads, cells_sort_threads},
    {"bands_after_serial", cells_sort_threads, cells_sort_alone},
};
enum { SORTS = sizeof sorts / sizeof *sorts };
//<

//> Time a sort
struct sorting {
    cell_sort *sort, *before;
    const struct grid *grid;
    struct points points;
    int threads;
};

static void run_sort(void *context)
{
    struct sorting *s = context;
    struct cells cells = s->sort(s->grid, s->points, s->threads);
    cells_free(&cells);
}

static void run_before(void *context)
{
    struct sorting *s = context;
    struct cells cells = s->before(s->grid, s->points, s->threads);
    cells_free(&cells);
}
//<

//> Get memory, copy memory
struct memory {
    size_t bytes;
    int threads;
    char *from, *to; // of as many bytes
};

static void touch(char *memory, size_t bytes, int threads)
{
#pragma omp parallel for num_threads(threads)
    for (size_t at = 0; at < bytes; at += 4096)
        memory[at] = 1;
}

static void get_small_pages(void *context)
{
    struct memory *m = context;
    char *memory = mmap(NULL, m->bytes, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        fail("no memory for %zu bytes", m->bytes);
#ifdef MADV_NOHUGEPAGE
    madvise(memory, m->bytes, MADV_NOHUGEPAGE);
#endif
    touch(memory, m->bytes, m->threads);
    munmap(memory, m->bytes);
}

static void get_large_pages(void *context)
{
    struct memory *m = context;
    char *memory = allocate(m->bytes, 1);
    touch(memory, m->bytes, m->threads);
    free(memory);
}

static void copy(void *context)
{
    struct memory *m = context;
#pragma omp parallel for num_threads(m->threads)
    for (int k = 0; k < m->threads; k++) {
        size_t begin = m->bytes * k / m->threads;
        size_t end = m->bytes * (k + 1) / m->threads;
        memcpy(m->to + begin, m->from + begin, end - begin);
    }
}
//<

//> Count who stands elsewhere
// How many points are not where chapter 4's sort puts them.
static uint32_t moved(const struct sorting *s)
{
    struct cells right = cells_sort(s->grid, s->points);
    struct cells found = s->sort(s->grid, s->points, s->threads);
    uint32_t count = 0;
    for (uint32_t k = 0; k < s->points.n; k++)
        count += found.point[k] != right.point[k];
    cells_free(&found);
    cells_free(&right);
    return count;
}
//<

//> Time one kind of points
// A sort that follows another, of other sizes, may get memory that the
// system must first find and clear. So each runs once before it is
// timed, and finds what it has itself just given back; but the last one
// follows another, to show what that costs.
static void print_trials(const char *kind, const char *name,
                         const struct trial trials[2], uint32_t n,
                         uint32_t moved)
{
    print_word(stdout, kind);
    printf("_%s_%u\t%u\t%d", name, n, n, omp_get_num_procs());
    print_summary(&trials[0].summary, n);
    print_summary(&trials[1].summary, n);
    printf("\t%u\n", moved);
}

static void time_kind(const char *kind, uint32_t n, int count)
{
    struct points points = generate(find_distribution(kind), n, 1);
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct grid grid = grid_fit(&question, 2);
    struct sorting sorting[2 * SORTS];
    struct trial trials[2 * SORTS];
    for (int k = 0; k < 2 * SORTS; k++) {
        sorting[k] = (struct sorting){
            sorts[k / 2].sort, sorts[k / 2].before, &grid, points,
            k % 2 ? omp_get_num_procs() : 1};
        trials[k] = (struct trial){.work = run_sort,
                                   .prepare = run_before,
                                   .context = &sorting[k]};
    }
    time_in_turn(count, trials, 2 * SORTS);
    for (int k = 0; k < SORTS; k++)
        print_trials(kind, sorts[k].name, &trials[2 * k], n,
                     moved(&sorting[2 * k + 1]));
    grid_free(&grid);
    points_free(&points);
}
//<

//> Time the memory
static void time_memory(uint32_t n, int count)
{
    const size_t bytes = (size_t)n * 18; // home, items, point, start
    struct memory one = {bytes, 1, allocate(bytes, 1),
                         allocate(bytes, 1)};
    struct memory all = one;
    all.threads = omp_get_num_procs();
    memset(one.from, 1, bytes);
    memset(one.to, 1, bytes);
    struct trial trials[] = {{.work = get_small_pages, .context = &one},
                             {.work = get_small_pages, .context = &all},
                             {.work = get_large_pages, .context = &one},
                             {.work = get_large_pages, .context = &all},
                             {.work = copy, .context = &one},
                             {.work = copy, .context = &all}};
    time_in_turn(count, trials, 6);
    print_trials("memory", "small", trials, n, 0);
    print_trials("memory", "large", trials + 2, n, 0);
    print_trials("memory", "copy", trials + 4, n, 0);
    free(one.to);
    free(one.from);
}
//<

static bool is_memory(const char *kind)
{
    return strcmp(kind, "memory") == 0;
}

int main(int argc, char **argv)
{
    char *uniform[] = {"uniform"};
    fail_as("sorts");
    uint32_t n = argument(argc, argv, 1, "POINTS", 1000000, 2, MANY);
    int count = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    char **kinds = argc > 3 ? argv + 3 : uniform;
    int many = argc > 3 ? argc - 3 : 1;
    for (int k = 0; k < many; k++)
        if (!is_memory(kinds[k]) && !find_distribution(kinds[k]))
            fail("KIND: there are no points called %s", kinds[k]);
    report_provenance(stdout);
    puts("name\tn\tthreads\tone\tone_q1\tone_q3"
         "\tall\tall_q1\tall_q3\tmoved");
    for (int k = 0; k < many; k++)
        if (is_memory(kinds[k]))
            time_memory(n, count);
        else
            time_kind(kinds[k], n, count);
    return 0;
}
//<
