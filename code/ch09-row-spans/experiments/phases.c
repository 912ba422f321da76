// Every step of a search by row spans, on one thread and on all
// processors, with results that go straight to their places, batch by
// batch or chunk by chunk, or back by way of the records, or that stay
// in the order of the cells; beside chapter 4's sort and copy, and
// beside the floor: every point read, every answer written once.
//     phases [POINTS [TRIALS]]
#include "ch05-collisions/partition.h"
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/span_kernels.h"
#include "common/experiment.h"

struct phases {
    struct question question;
    struct partition partition;
    uint32_t *in_order, *in_chunk; // s, s % CHUNK at [s]
    struct workspace *workspace;
    struct answers *answers;
};

static void fit(void *context)
{
    struct phases *p = context;
    struct grid grid = grid_fit(&p->question, POINTS_PER_SPAN_CELL);
    grid_free(&grid);
}

static void sort_and_copy(void *context)
{
    struct phases *p = context;
    struct sorted sorted =
        sorted_make(&p->question, POINTS_PER_SPAN_CELL);
    sorted_free(&sorted);
}

static void fit_and_partition(void *context)
{
    struct phases *p = context;
    struct mark mark = workspace_mark(p->workspace);
    partition_make(&p->question, POINTS_PER_SPAN_CELL, RESTORE,
                   p->workspace);
    workspace_release(p->workspace, mark);
}

static void search(void *context)
{
    struct phases *p = context;
    search_row_spans(&p->question, &p->partition, p->workspace,
                     p->answers);
}

// Sorted point s has result place[s].
static void search_with(struct phases *p, const uint32_t *place)
{
    struct mark mark = workspace_mark(p->workspace);
    struct neighbor *results = workspace_take(
        p->workspace, p->question.points.n, sizeof *results);
    const struct scene scene = {p->question.space, &p->partition.sorted,
                                span_kernels()};
    struct batch_search search = nearest_search(&scene, place, results);
    answer_all(&p->question, &scene, &search, 1);
    workspace_release(p->workspace, mark);
}

static void search_by_batches(void *context)
{
    struct phases *p = context;
    search_with(p, p->partition.sorted.cells.point);
}

static void search_in_place(void *context)
{
    struct phases *p = context;
    search_with(p, p->in_order);
}

// The answers of a chunk are kept, and then taken to their places.
static void search_chunk(const void *context, uint32_t begin,
                         uint32_t end, struct counts *counts)
{
    const struct phases *p = context;
    const struct scene scene = {p->question.space, &p->partition.sorted,
                                span_kernels()};
    const uint32_t *point = p->partition.sorted.cells.point;
    struct neighbor results[CHUNK];
    struct batch_search search =
        nearest_search(&scene, p->in_chunk, results);
    answer_chunk(&scene, &search, 1, begin, end, counts);
    for (uint32_t s = begin; s < end; s++) {
        p->answers->nearest[point[s]] = results[s - begin].index;
        p->answers->nearest2[point[s]] = results[s - begin].distance2;
    }
}

static void search_by_chunks(void *context)
{
    struct phases *p = context;
    share_chunks(&p->question, search_chunk, p);
}

static void all(void *context)
{
    struct phases *p = context;
    row_spans(&p->question, p->answers);
}

static void touch_floor(void *context)
{
    struct phases *p = context;
    const struct points points = p->question.points;
    uint32_t *nearest = p->answers->nearest;
    double *nearest2 = p->answers->nearest2;
#pragma omp parallel for num_threads(p->question.threads)
    for (uint32_t i = 0; i < points.n; i++) {
        nearest[i] = i;
        nearest2[i] = points.x[i] + points.y[i];
    }
}

static const struct {
    const char *name;
    void (*work)(void *);
} phases[] = {{"fit", fit},
              {"copied", sort_and_copy},
              {"partitioned", fit_and_partition},
              {"by_batch", search_by_batches},
              {"by_chunk", search_by_chunks},
              {"search", search},
              {"in_place", search_in_place},
              {"all", all},
              {"floor", touch_floor}};
enum { PHASES = COUNT_OF(phases) };

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000000, 2, MANY);
    int count = parameter(&e, "TRIALS", 3, 1, MANY);
    struct workspace workspace = {0};
    struct phases one = {.question = uniform_question(STANDARD, n, 1),
                         .in_order = take(n, sizeof *one.in_order),
                         .in_chunk = take(n, sizeof *one.in_chunk),
                         .answers = new_answers(n, NEAREST),
                         .workspace = &workspace};
    one.question.workspace = &workspace;
    one.partition = partition_make(&one.question, POINTS_PER_SPAN_CELL,
                                   RESTORE, &workspace);
    for (uint32_t s = 0; s < n; s++)
        one.in_order[s] = s, one.in_chunk[s] = s % CHUNK;
    struct phases all = one;
    all.question.threads = omp_get_num_procs();
    struct trial trials[2 * PHASES];
    for (int k = 0; k < 2 * PHASES; k++)
        trials[k] =
            (struct trial){phases[k / 2].work, k % 2 ? &all : &one,
                           .prepare = phases[k / 2].work};
    time_in_turn(count, trials, 2 * PHASES);
    print_header(&e, "name n threads one:3 all:3");
    for (int k = 0; k < PHASES; k++)
        row_of_times(&trials[2 * k], 2, n, "%s\t%u\t%d", phases[k].name,
                     n, all.question.threads);
}
