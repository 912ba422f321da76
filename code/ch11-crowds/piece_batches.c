//> Search by pieces
// A piece is a scene of its own for chapter 9's driver: plain geometry,
// its own grid, its own points. A kernel of ours withdraws a
// certificate where another piece may have something nearer. As many
// steps as chapter 9, and a few more for queries near a border.
#include "ch11-crowds/piece_batches.h"
#include "ch09-row-spans/batch_search.h"
#include "ch09-row-spans/span_kernels.h"
#include "ch11-crowds/point_search.h"
#include "common/min_max.h"
#include <math.h>

//> Hold the scene of a piece
// The scene comes first, so that its address is that of the
// whole.
struct all_pieces {
    struct scene scene; // of all points
    const struct pieces *pieces;
    struct box box;     // of all points
    uint64_t max_steps; // of a query
};

struct piece_scene {
    struct scene scene;
    const struct all_pieces *all;
    const struct piece *piece;
    uint32_t given_up; // how many queries
};
//<

//> Bound the distance from other pieces
//> Bound it along an axis
// Other pieces begin where the region ends. With wraparound what is
// beyond the seam is at least so far away; without, the period is
// INFINITY.
static inline double margin_of(double x, double low, double high,
                               double first, double last, double period)
{
    const double direct = MIN(x - low, high - x);
    const double around = period - MAX(x - first, last - x);
    return MIN(direct, around);
}
//<

static inline double piece_margin(const struct piece_scene *scene,
                                  double x, double y)
{
    const struct box *r = &scene->piece->region;
    const struct box *all = &scene->all->box;
    const struct space space = scene->all->scene.space;
    const bool wraps = space.geometry == WRAPAROUND;
    const double across =
        margin_of(x, r->left, r->right, all->left, all->right,
                  wraps ? space.width : INFINITY);
    const double up =
        margin_of(y, r->bottom, r->top, all->bottom, all->top,
                  wraps ? space.height : INFINITY);
    return MIN(across, up);
}
//<

//> Certify against other pieces
// What is nearest in the piece is nearest of all if it is nearer than
// the end of the region.
static uint32_t nearest_in_piece(const struct scene *scene,
                                 const struct staging *staging,
                                 const struct query_batch *batch,
                                 struct batch_result *result)
{
    const struct piece_scene *piece = (const void *)scene;
    const double *x = scene->sorted->points.x + batch->begin;
    const double *y = scene->sorted->points.y + batch->begin;
    uint32_t certified =
        scene->kernels->nearest(scene, staging, batch, result);
    for (int lane = 0; lane < BATCH; lane++) {
        const double margin = piece_margin(piece, x[lane], y[lane]);
        const bool inside = result->distance2[lane] < margin * margin;
        certified &= ~((uint32_t)!inside << lane);
    }
    return certified;
}
//<

//> Answer exactly over all pieces
// What the kernel has found is a bound, and will be found again. It may
// be far away, where a block has no other point.
static void exact_nearest(const struct scene *scene,
                          const void *context, uint32_t s,
                          struct neighbor *found, struct counts *counts)
{
    struct piece_scene *piece = (void *)(uintptr_t)scene;
    const struct all_pieces *all = piece->all;
    (void)context;
    s += piece->piece->begin;
    struct tree_query query =
        query_for(&all->scene, all->pieces, s, all->max_steps);
    if (found->index != NO_INDEX && found->index != query.query.self)
        query.query.best2 = found->distance2;
    compare_nearest(&query, beside_begin(s),
                    beside_end(s, all->pieces->sorted.points.n));
    *found = answer_of(&query, query_nearest(&query), counts);
    piece->given_up += found->index == NO_INDEX;
}
//<

//> Answer for points in one place
// For the first of them, and once for all others: a lower index than
// theirs may be in another piece, where distances vanish.
static struct neighbor nearest_of_place(const struct all_pieces *all,
                                        const struct piece *piece,
                                        uint32_t s,
                                        struct counts *counts)
{
    struct tree_query query = query_for(
        &all->scene, all->pieces, piece->begin + s, all->max_steps);
    const uint32_t self = query.query.self;
    const uint32_t other =
        piece->lowest != self ? piece->lowest : piece->second;
    if (other != NO_INDEX) {
        query.query.best2 = 0;
        query.query.nearest = other;
    } else {
        compare_nearest(
            &query, beside_begin(piece->begin + s),
            beside_end(piece->begin + s, all->pieces->sorted.points.n));
    }
    return answer_of(&query, query_nearest(&query), counts);
}

static void answer_place(struct piece_scene *scene,
                         struct neighbor *results,
                         const uint32_t *inverse, struct counts *counts)
{
    const struct piece *piece = scene->piece;
    const struct points p = piece->sorted.points;
    struct neighbor others = {0, NO_INDEX};
    for (uint32_t s = 0; s < p.n; s++) {
        const bool first =
            piece->sorted.cells.point[s] == piece->lowest;
        const bool again =
            s > 0 && p.x[s] == p.x[s - 1] && p.y[s] == p.y[s - 1];
        if (first || !again || others.index == NO_INDEX) {
            struct neighbor found =
                nearest_of_place(scene->all, piece, s, counts);
            scene->given_up += found.index == NO_INDEX;
            results[inverse[s]] = found;
            if (!first)
                others = found;
        } else {
            results[inverse[s]] = others;
            counts->distances++;
        }
    }
}
//<

//> Search a piece by batches
static uint32_t search_piece(const struct all_pieces *all,
                             const struct piece *piece,
                             struct neighbor *results,
                             struct counts *counts)
{
    const uint32_t *inverse = all->pieces->inverse + piece->begin;
    struct piece_scene scene = {
        {{STANDARD, 0, 0}, &piece->sorted, all->scene.kernels},
        all,
        piece,
        0};
    const struct batch_search search = {.kernel = nearest_in_piece,
                                        .max_reach = INFINITY,
                                        .exact = exact_nearest,
                                        .results = results,
                                        .inverse = inverse};
    if (piece->is_place)
        answer_place(&scene, results, inverse, counts);
    else
        answer_chunk(&scene.scene, &search, 1, 0,
                     piece->sorted.points.n, counts);
    return scene.given_up;
}
//<

//> Search all pieces
uint64_t steps_allowed(uint32_t n)
{
    return 512 + 64 * (uint64_t)log2(n);
}

uint32_t search_pieces(const struct question *question,
                       const struct pieces *pieces, uint64_t max_steps,
                       struct neighbor *results)
{
    const struct all_pieces all = {scene_of(question, pieces), pieces,
                                   pieces->node[0].box, max_steps};
    uint32_t given_up = 0;
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic) reduction(+ : given_up)
    for (uint32_t k = 0; k < pieces->leaves; k++) {
        struct counts counts = {0};
        for (uint32_t piece = 0; piece < pieces->count[k]; piece++)
            given_up += search_piece(
                &all, &pieces->piece[pieces->first[k] + piece], results,
                &counts);
        counts_add(question->counts, &counts);
    }
    return given_up;
}
//<
//<
