// Sorts points of every kind named, or uniform ones, by cell, with
// counts that threads share and counts of their own, on one thread and
// on all processors. The kind "memory" shows what the machine needs for
// as much memory as the partition writes: to get it, and to copy it.
//
//     sorts [POINTS [TRIALS [KIND...]]]
#include "ch04-cell-sort/sorted.h"
#include "ch05-collisions/partition.h"
#include "ch05-collisions/shared.h"
#include "common/allocate.h"
#include "common/experiment.h"
#include "common/fail.h"
#include "common/generate.h"
#include <omp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

// The partition keeps its memory between runs, or gets it anew.
enum memory_of { SORTED, KEPT, FRESH };

static const struct {
    const char *name;
    cell_sort *sort; // NULL: the partition
    enum memory_of memory;
} sorts[] = {
    {"serial", cells_sort_alone, SORTED},
    {"atomic", cells_sort_atomic, SORTED},
    {"private", cells_sort_private, SORTED},
    {"partition", NULL, KEPT},
    {"partition_fresh", NULL, FRESH},
};
enum { SORTS = sizeof sorts / sizeof *sorts };

struct sorting {
    cell_sort *sort;
    enum memory_of memory;
    const struct grid *grid;
    struct points points;
    int threads;
    uint32_t *found; // the order, for whom it is wanted; or NULL
};

static struct workspace kept;

static void keep_order(const struct sorting *s, const uint32_t *point)
{
    if (s->found)
        memcpy(s->found, point, s->points.n * sizeof *point);
}

static void run_sort(void *context)
{
    struct sorting *s = context;
    if (s->memory == SORTED) {
        struct cells cells = s->sort(s->grid, s->points, s->threads);
        keep_order(s, cells.point);
        cells_free(&cells);
        return;
    }
    struct workspace fresh = {0};
    struct workspace *workspace = s->memory == KEPT ? &kept : &fresh;
    struct mark mark = workspace_mark(workspace);
    struct partition found = partition_points(
        s->grid, s->points, s->threads, NO_RESTORE, workspace);
    keep_order(s, found.sorted.cells.point);
    workspace_release(workspace, mark);
    workspace_free(&fresh);
}

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

// How many points are not where chapter 4's sort puts them.
static uint32_t moved(const struct sorting *sorting)
{
    struct sorting s = *sorting;
    struct cells right = cells_sort(s.grid, s.points);
    s.found = allocate(s.points.n, sizeof *s.found);
    run_sort(&s);
    uint32_t count = 0;
    for (uint32_t k = 0; k < s.points.n; k++)
        count += s.found[k] != right.point[k];
    free(s.found);
    cells_free(&right);
    return count;
}

// A sort that follows another, of other sizes, may get memory that the
// system must first find and clear. So each runs once before it is
// timed, and finds what it has itself just given back; but the last one
// gets its memory anew, to show what that costs.
static void print_trials(const char *kind, const char *name,
                         const struct trial trials[2], uint32_t n,
                         uint32_t moved)
{
    row_begin("%s_%s_%u\t%u\t%d", kind, name, n, n,
              omp_get_num_procs());
    row_times(&trials[0].summary, n);
    row_times(&trials[1].summary, n);
    row_cells("\t%u", moved);
    row_end();
}

static void time_kind(const char *kind, uint32_t n, int count)
{
    struct points points = generate(find_distribution(kind), n, 1);
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct grid grid = grid_fit(&question, 2);
    struct sorting sorting[2 * SORTS];
    struct trial trials[2 * SORTS];
    for (int k = 0; k < 2 * SORTS; k++) {
        sorting[k] = (struct sorting){sorts[k / 2].sort,
                                      sorts[k / 2].memory,
                                      &grid,
                                      points,
                                      k % 2 ? omp_get_num_procs() : 1,
                                      NULL};
        trials[k] = (struct trial){.work = run_sort,
                                   .prepare = run_sort,
                                   .context = &sorting[k]};
    }
    time_in_turn(count, trials, 2 * SORTS);
    for (int k = 0; k < SORTS; k++)
        print_trials(kind, sorts[k].name, &trials[2 * k], n,
                     moved(&sorting[2 * k + 1]));
    grid_free(&grid);
    points_free(&points);
}

static void time_memory(uint32_t n, int count)
{
    const size_t bytes = (size_t)n * 46; // records, points, start
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

static bool is_memory(const char *kind)
{
    return strcmp(kind, "memory") == 0;
}

int main(int argc, char **argv)
{
    char *uniform[] = {"uniform"};
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000000, 2, MANY);
    int count = parameter(&e, "TRIALS", 3, 1, MANY);
    char **kinds = argc > 3 ? argv + 3 : uniform;
    int many = argc > 3 ? argc - 3 : 1;
    e.next = argc;
    for (int k = 0; k < many; k++)
        if (!is_memory(kinds[k]) && !find_distribution(kinds[k]))
            fail("KIND: there are no points called %s", kinds[k]);
    columns(&e, "name n threads one:3 all:3 moved");
    for (int k = 0; k < many; k++)
        if (is_memory(kinds[k]))
            time_memory(n, count);
        else
            time_kind(kinds[k], n, count);
    return 0;
}
