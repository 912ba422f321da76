// Sorts points of every kind named, or uniform ones, by cell, with
// counts that threads share and counts of their own, on one thread and
// on all processors. The kind "memory" shows what the machine needs for
// as much memory as the partition writes: to get it, and to copy it.
//     sorts [POINTS [TRIALS [KIND...]]]
#include "ch04-cell-sort/sorted.h"
#include "ch05-collisions/partition.h"
#include "ch05-collisions/shared.h"
#include "common/experiment.h"
#include <sys/mman.h>

static struct workspace kept;

typedef struct cells cell_sort(const struct grid *grid,
                               struct points points, int threads);

static struct cells sort_alone(const struct grid *grid,
                               struct points points, int threads)
{
    (void)threads;
    return cells_sort(grid, points);
}

// What does not sort by cell is the partition, in a workspace that it
// keeps between runs, or NULL, in memory that it gets anew.
static const struct {
    const char *name;
    cell_sort *sort;
    struct workspace *workspace;
} sorts[] = {
    {"serial", sort_alone, NULL},
    {"atomic", cells_sort_atomic, NULL},
    {"private", cells_sort_private, NULL},
    {"partition", NULL, &kept},
    {"partition_fresh", NULL, NULL},
};
enum { SORTS = COUNT_OF(sorts) };

struct sorting {
    cell_sort *sort;
    struct workspace *workspace;
    const struct grid *grid;
    struct points points;
    int threads;
    uint32_t *found; // where to copy the order; or NULL
};

static void copy_order(const struct sorting *s, const uint32_t *point)
{
    if (s->found)
        memcpy(s->found, point, s->points.n * sizeof *point);
}

static void run_sort(void *context)
{
    struct sorting *s = context;
    if (s->sort) {
        struct cells cells = s->sort(s->grid, s->points, s->threads);
        copy_order(s, cells.point);
        cells_free(&cells);
        return;
    }
    struct workspace fresh = {0};
    struct workspace *workspace = s->workspace ? s->workspace : &fresh;
    struct mark mark = workspace_mark(workspace);
    struct partition found = partition_points(
        s->grid, s->points, s->threads, NO_RESTORE, workspace);
    copy_order(s, found.sorted.cells.point);
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
static uint32_t moved(struct sorting s)
{
    struct cells right = cells_sort(s.grid, s.points);
    s.found = take(s.points.n, sizeof *s.found);
    run_sort(&s);
    uint32_t count = 0;
    for (uint32_t k = 0; k < s.points.n; k++)
        count += s.found[k] != right.point[k];
    cells_free(&right);
    return count;
}

static void print_trials(const char *name, const struct trial trials[2],
                         uint32_t n, uint32_t moved)
{
    row_begin("%s_%u\t%u\t%d", name, n, n, omp_get_num_procs());
    row_times(&trials[0].summary, n);
    row_times(&trials[1].summary, n);
    row_cells("\t%u", moved);
    row_end();
}

// All but the partition in its workspace get their large arrays anew
// from the system each time. Each sort runs once before it is timed, so
// that it does not depend on what ran before it.
static void time_kind(const char *kind, uint32_t n, int count)
{
    struct question question = kind_question(kind, n, 1);
    struct grid grid = grid_fit(&question, 2);
    struct sorting sorting[2 * SORTS];
    struct trial trials[2 * SORTS];
    for (int k = 0; k < 2 * SORTS; k++) {
        sorting[k] = (struct sorting){
            sorts[k / 2].sort, sorts[k / 2].workspace,          &grid,
            question.points,   k % 2 ? omp_get_num_procs() : 1, NULL};
        trials[k] = (struct trial){.work = run_sort,
                                   .prepare = run_sort,
                                   .context = &sorting[k]};
    }
    time_in_turn(count, trials, 2 * SORTS);
    for (int k = 0; k < SORTS; k++) {
        char name[60];
        sprintf(name, "%s_%s", kind, sorts[k].name);
        print_trials(name, &trials[2 * k], n,
                     moved(sorting[2 * k + 1]));
    }
    grid_free(&grid);
}

static void time_memory(uint32_t n, int count)
{
    const size_t bytes = (size_t)n * 46; // records, points, start
    struct memory one = {bytes, 1, take(bytes, 1), take(bytes, 1)};
    struct memory all = one;
    all.threads = omp_get_num_procs();
    struct trial trials[] = {{get_small_pages, &one},
                             {get_small_pages, &all},
                             {get_large_pages, &one},
                             {get_large_pages, &all},
                             {copy, &one},
                             {copy, &all}};
    time_in_turn(count, trials, 6);
    print_trials("memory_small", trials, n, 0);
    print_trials("memory_large", trials + 2, n, 0);
    print_trials("memory_copy", trials + 4, n, 0);
}

int main(int argc, char **argv)
{
    char *uniform[] = {"uniform", NULL};
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000000, 2, MANY);
    int count = parameter(&e, "TRIALS", 3, 1, MANY);
    char **kinds = argc > e.next ? argv + e.next : uniform;
    e.next = argc;
    for (char **kind = kinds; *kind; kind++)
        if (strcmp(*kind, "memory") != 0 && !find_distribution(*kind))
            fail("KIND: there are no points called %s", *kind);
    print_header(&e, "name n threads one:3 all:3 moved");
    for (char **kind = kinds; *kind; kind++) {
        if (strcmp(*kind, "memory") == 0)
            time_memory(n, count);
        else
            time_kind(*kind, n, count);
        forget();
    }
}
