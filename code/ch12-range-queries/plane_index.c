//> Make the plane's index
// A sample, then the counts of all cells, decide between one grid and
// chapter 11's pieces. n log n steps at worst.
#include "ch12-range-queries/plane_index.h"
#include "ch05-collisions/partition.h"
#include "ch11-crowds/by_sample.h"
#include <math.h>
#include <stdlib.h>

//> Make one piece of a grid
static struct pieces one_piece(const struct sorted *sorted,
                               struct workspace *workspace)
{
    const struct axis *x = &sorted->grid.x, *y = &sorted->grid.y;
    struct pieces pieces = {.sorted = *sorted, .leaves = 1};
    const struct box box = {x->border[0], x->border[x->count],
                            y->border[0], y->border[y->count]};
    const struct box everything = {-INFINITY, INFINITY, -INFINITY,
                                   INFINITY};
    pieces.node = workspace_take(workspace, 1, sizeof *pieces.node);
    pieces.node[0] = (struct node){.box = box};
    pieces.piece = workspace_take(workspace, 1, sizeof *pieces.piece);
    pieces.piece[0] =
        (struct piece){.sorted = *sorted, .region = everything};
    return pieces;
}
//<

//> Order what is in one place
// By index: of those that are equally far, the first are wanted.
static int lower_first(const void *one, const void *other)
{
    const uint32_t a = *(const uint32_t *)one;
    const uint32_t b = *(const uint32_t *)other;
    return (a > b) - (a < b);
}

static void order_place(const struct question *question,
                        const struct piece *piece)
{
    const struct points p = piece->sorted.points;
    uint32_t *point = piece->sorted.cells.point;
    qsort(point, p.n, sizeof *point, lower_first);
    for (uint32_t s = 0; s < p.n; s++) {
        p.x[s] = question->points.x[point[s]];
        p.y[s] = question->points.y[point[s]];
    }
}
//<

//> List the pieces in order
static void list_pieces(const struct question *question,
                        struct plane_index *index,
                        struct workspace *workspace)
{
    const struct pieces *pieces = &index->pieces;
    for (uint32_t k = 0; k < pieces->leaves; k++)
        index->count += pieces->count[k];
    index->piece =
        workspace_take(workspace, index->count, sizeof *index->piece);
    uint32_t at = 0;
    for (uint32_t k = 0; k < pieces->leaves; k++)
        for (uint32_t j = 0; j < pieces->count[k]; j++)
            index->piece[at++] = pieces->first[k] + j;
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic, 16)
    for (uint32_t k = 0; k < index->count; k++)
        if (pieces->piece[index->piece[k]].is_place)
            order_place(question, &pieces->piece[index->piece[k]]);
}

uint32_t piece_of(const struct plane_index *index, uint32_t s)
{
    uint32_t low = 0, high = index->count;
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        const uint32_t piece = index->piece[middle];
        if (index->pieces.piece[piece].begin <= s)
            low = middle;
        else
            high = middle;
    }
    return low;
}
//<

//> Try a single grid
// To compare one by one costs more than in batches: so a crowd is worth
// a cut sooner than in chapter 11.
static const double MAX_DENSITY = 2;

static bool take_one_grid(const struct question *question,
                          struct plane_index *index,
                          struct workspace *workspace)
{
    const struct partition partition = partition_make(
        question, POINTS_PER_PLANE_CELL, NO_RESTORE, workspace);
    const struct sorted *sorted = &partition.sorted;
    if (!cells_are_even(sorted, POINTS_PER_PLANE_CELL, MAX_DENSITY))
        return false;
    index->is_even = true;
    index->pieces = one_piece(sorted, workspace);
    index->count = 1;
    index->piece = workspace_take(workspace, 1, sizeof *index->piece);
    index->piece[0] = 0;
    return true;
}

struct plane_index plane_index_make(const struct question *question,
                                    struct workspace *workspace)
{
    struct plane_index index = {.space = question->space,
                                .threads = question->threads};
    struct extent box[2];
    struct question known = *question;
    box_of_points(question, &box[0], &box[1]);
    known.box = box;
    known.workspace = workspace;
    const struct mark mark = workspace_mark(workspace);
    if (sample_is_even(&known, MAX_DENSITY) &&
        take_one_grid(&known, &index, workspace))
        return index;
    workspace_release(workspace, mark);
    index.pieces = pieces_make(question, workspace);
    list_pieces(question, &index, workspace);
    return index;
}
//<
//<
