// Crowds: the search by pieces and the one that chooses, against the
// plainest search there is; divide and conquer, made to answer for
// all; distances that grow no faster than log n, whatever the points;
// and what the pieces promise.
#include "algorithms.h"
#include "ch11-crowds/adaptive.h"
#include "ch11-crowds/arcs.h"
#include "ch11-crowds/by_sample.h"
#include "ch11-crowds/divide.h"
#include "ch11-crowds/experiments/predict.h"
#include "ch11-crowds/grow.h"
#include "ch11-crowds/piece_batches.h"
#include "ch11-crowds/point_search.h"
#include "common/allocate.h"
#include "common/generate.h"
#include "common/min_max.h"
#include "common/random.h"
#include "harness.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- questions -----------------------------------------------------
static struct question question_of(struct points points,
                                   enum geometry geometry, int threads)
{
    double x0 = 0, y0 = 0, x1 = 1, y1 = 1;
    for (uint32_t i = 0; i < points.n; i++) {
        x0 = fmin(x0, points.x[i]), x1 = fmax(x1, points.x[i]);
        y0 = fmin(y0, points.y[i]), y1 = fmax(y1, points.y[i]);
    }
    return (struct question){
        points, {geometry, x1 - x0, y1 - y0}, threads};
}

static uint32_t count_near(const struct answers *right,
                           const struct answers *found, uint32_t n)
{
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < n; i++)
        wrong += right->nearest2[i] != found->nearest2[i] ||
                 right->nearest[i] != found->nearest[i];
    return wrong;
}

static uint32_t count_far(const struct answers *right,
                          const struct answers *found, uint32_t n)
{
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < n; i++)
        wrong += right->furthest2[i] != found->furthest2[i] ||
                 right->furthest[i] != found->furthest[i];
    return wrong;
}

// By all four ways: pieces, the choice, and the nearest with so few
// steps that some or all queries give up.
static void check_one(const char *name, const struct question *question,
                      const struct answers *right)
{
    static const uint64_t steps[] = {0, 40};
    const uint32_t n = question->points.n;
    struct answers found = answers_allocate(n);
    search_function *const rows[] = {adaptive, by_sample};
    for (int row = 0; row < 2; row++) {
        memset(found.nearest, 0xA5, n * sizeof *found.nearest);
        memset(found.furthest, 0xA5, n * sizeof *found.furthest);
        rows[row](question, &found);
        CHECK_INT(0, count_near(right, &found, n),
                  "nearest, row %d, %u %s points, geometry %d", row, n,
                  name, question->space.geometry);
        CHECK_INT(0, count_far(right, &found, n),
                  "furthest, row %d, %u %s points, geometry %d", row, n,
                  name, question->space.geometry);
    }
    for (int k = 0; k < 2; k++) {
        struct workspace workspace = {0};
        struct pieces pieces = pieces_make(question, &workspace);
        memset(found.nearest, 0xA5, n * sizeof *found.nearest);
        search_nearest_pieces(question, &pieces, steps[k], &workspace,
                              &found);
        CHECK_INT(0, count_near(right, &found, n),
                  "nearest in %d steps, %u %s points, geometry %d",
                  (int)steps[k], n, name, question->space.geometry);
        workspace_free(&workspace);
    }
    answers_free(&found);
}

static void check_points(const char *name, struct points points,
                         int threads)
{
    struct answers right = answers_allocate(points.n);
    for (int g = STANDARD; g <= WRAPAROUND; g++) {
        struct question question = question_of(points, g, threads);
        if (!isfinite(question.space.width) ||
            !isfinite(question.space.height))
            continue;
        search_plainly(&question, &right);
        check_one(name, &question, &right);
    }
    answers_free(&right);
}

// Another number of threads means new threads: not at each set.
static void check_generators(int threads)
{
    static const uint32_t lengths[] = {2, 3, 4, 7, 8, 95, 257, 2000};
    const uint32_t most = at_most("MOST_POINTS", 2000);
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++)
        for (int d = 0; d < distribution_count; d++) {
            if (lengths[k] > most)
                continue;
            test_seed(k);
            struct points points =
                generate(&distributions[d], lengths[k], k);
            check_points(distributions[d].name, points, threads);
            points_free(&points);
        }
}

static void every_generator(void)
{
    for (int threads = 1; threads <= 4; threads *= 2)
        check_generators(threads);
}

// So many points that there are cuts, judged by the tiles of chapter 2.
static void check_cut(const char *name, struct points points)
{
    struct answers right = answers_allocate(points.n);
    for (int g = STANDARD; g <= WRAPAROUND; g++) {
        struct question question = question_of(points, g, 2);
        if (!isfinite(question.space.width) ||
            !isfinite(question.space.height))
            continue;
        find_algorithm("tiles")->run(&question, &right);
        check_one(name, &question, &right);
    }
    answers_free(&right);
}

// A share of the points in one place, so that parts of the sample are
// only that place, and cannot be cut.
static struct points with_a_heavy_place(uint32_t n, double share,
                                        uint64_t seed)
{
    struct points points =
        generate(find_distribution("uniform"), n, seed);
    struct random random = {seed};
    for (uint32_t i = 0; i < n; i++)
        if (random_uniform(&random) < share)
            points.x[i] = 0.3, points.y[i] = 0.5;
    return points;
}

static void tens_of_thousands(void)
{
    static const double shares[] = {0.5, 0.8, 0.9, 0.97, 0.99};
    const uint32_t n = at_most("MOST_POINTS", 80000) / 2;
    for (int d = 0; d < distribution_count; d++) {
        test_seed(2);
        struct points points = generate(&distributions[d], n, 2);
        check_cut(distributions[d].name, points);
        points_free(&points);
    }
    for (int k = 0; k < 5; k++)
        for (int seed = 1; seed <= 2; seed++) {
            test_seed(seed);
            struct points points =
                with_a_heavy_place(n, shares[k], seed);
            check_cut("heavy", points);
            points_free(&points);
        }
}

static void check_moved(const char *name, double scale, double x,
                        double y, int threads)
{
    for (int d = 0; d < distribution_count; d++) {
        struct points points = generate(&distributions[d], 400, 5);
        char what[100];
        snprintf(what, sizeof what, "%s %s", name,
                 distributions[d].name);
        for (uint32_t i = 0; i < points.n; i++) {
            points.x[i] = x + scale * points.x[i];
            points.y[i] = y + scale * points.y[i];
        }
        check_points(what, points, threads);
        points_free(&points);
    }
}

static void moved_and_stretched(void)
{
    for (int t = 1; t <= 4; t *= 2) {
        check_moved("far off", 1, 1e8, -1e8, t);
        check_moved("very far off", 1, 1e15, 3e15, t);
        check_moved("tiny", 1e-150, 0, 0, t);
        check_moved("vanishing", 1e-161, 0, 0, t);
        check_moved("hardly there", 1e-310, 0, 0, t);
        check_moved("huge", 1e140, -5e139, 0, t);
        check_moved("overflowing", 1e154, 0, 0, t);
        check_moved("beyond all bounds", 1e297, 0, 0, t);
    }
}

// Few different coordinates: ties, duplicates, lines of equal x.
static void check_ties(uint64_t seed, int threads)
{
    test_seed(seed);
    struct random random = {seed};
    const uint32_t n = 2 + random_bits(&random) % 600;
    const int columns = 1 + random_bits(&random) % 20;
    const int rows = 1 + random_bits(&random) % 20;
    struct points points = points_allocate(n);
    for (uint32_t i = 0; i < n; i++) {
        points.x[i] =
            (double)(random_bits(&random) % columns) / columns;
        points.y[i] = (double)(random_bits(&random) % rows) / rows;
    }
    check_points("ties", points, threads);
    points_free(&points);
}

static void ties(void)
{
    for (int threads = 1; threads <= 4; threads *= 2)
        for (uint64_t seed = 0; seed < 60; seed++)
            check_ties(seed, threads);
}

// ---- counts --------------------------------------------------------
static double distances(const char *row, struct question question,
                        unsigned answered)
{
    const struct algorithm *algorithm = find_algorithm(row);
    struct answers found = answers_for(question.points.n, answered);
    const struct counts counts =
        count_operations(algorithm, &question, &found);
    answers_free(&found);
    return (double)counts.distances / question.points.n;
}

// At most 100 distances a point where there are ten thousand, nearest
// and furthest, and no more than twice as many among a million. But a
// place of many points costs all their pairs until they are enough to
// be a piece of their own: the 1,075 places of the geometric sequence
// are that for more than 75,000 points. Up to there it is held to the
// 100.
static double most_distances(const char *name, uint32_t n, double few)
{
    enum { PLACES_ARE_PIECES = 100000 };
    return strcmp(name, "geometric") == 0 && n < PLACES_ARE_PIECES
               ? 100
               : 2 * few;
}

static void no_crowd_is_quadratic(void)
{
    enum { FEW = 10000, MANY = 1000000, THREADS = 2 };
    const uint32_t many = MAX(FEW, at_most("MOST_POINTS", MANY));
    for (int d = 0; d < distribution_count; d++) {
        const char *name = distributions[d].name;
        struct points few = generate(&distributions[d], FEW, 1);
        struct points more = generate(&distributions[d], many, 1);
        for (int g = STANDARD; g <= WRAPAROUND; g++)
            for (unsigned answer = NEAREST; answer <= FURTHEST;
                 answer++) {
                const double one = distances(
                    "by-sample", question_of(few, g, THREADS), answer);
                const double other = distances(
                    "by-sample", question_of(more, g, THREADS), answer);
                CHECK(one < 100, "%s, geometry %d, answer %u: %g", name,
                      g, answer, one);
                CHECK(other <= most_distances(name, many, one),
                      "%s, geometry %d, answer %u: %g, then %g", name,
                      g, answer, one, other);
            }
        points_free(&few);
        points_free(&more);
    }
}

// Within a tenth among a million, from the density of the points and
// from the counts of the cells.
static void distances_are_predicted(void)
{
    static const char *const kinds[] = {"uniform", "clustered",
                                        "kuzmin", "log-normal"};
    enum { N = 1000000, SEED = 1 };
    if (at_most("MOST_POINTS", N) < N)
        return;
    for (int k = 0; k < 4; k++) {
        struct points points =
            generate(find_distribution(kinds[k]), N, SEED);
        struct question question = question_of(points, STANDARD, 1);
        struct workspace workspace = {0};
        const struct pieces pieces = pieces_make(&question, &workspace);
        const double counted = distances("adaptive", question, NEAREST);
        const double predicted[] = {
            predict_from_counts(&pieces),
            predict_from_density(&pieces, kinds[k], SEED)};
        for (int way = 0; way < 2; way++)
            CHECK(fabs(predicted[way] / counted - 1) < 0.1,
                  "%s, way %d: %g predicted, %g counted", kinds[k], way,
                  predicted[way], counted);
        workspace_free(&workspace);
        points_free(&points);
    }
}

static void threads_count_alike(void)
{
    for (int d = 0; d < distribution_count; d++) {
        struct points points = generate(&distributions[d], 20000, 3);
        double one = 0;
        for (int threads = 1; threads <= 4; threads++) {
            double found = distances(
                "adaptive", question_of(points, WRAPAROUND, threads),
                NEAREST | FURTHEST);
            one = threads == 1 ? found : one;
            CHECK_DOUBLE(one, found, "%s, %d threads",
                         distributions[d].name, threads);
        }
        points_free(&points);
    }
}

// A query that gives up has not compared more than it was allowed.
static void queries_keep_to_their_steps(void)
{
    static const uint64_t most[] = {0, 1, 10, 100};
    enum { N = 5000 };
    for (int d = 0; d < distribution_count; d++) {
        struct points points = generate(&distributions[d], N, 3);
        struct question question = question_of(points, WRAPAROUND, 1);
        struct workspace workspace = {0};
        const struct pieces pieces = pieces_make(&question, &workspace);
        const struct scene all = scene_of(&question, &pieces);
        for (int k = 0; k < 4; k++) {
            uint32_t wrong = 0;
            for (uint32_t s = 0; s < N; s++) {
                struct counts counts = {0};
                nearest_of_all(&all, &pieces, s, most[k], &counts);
                wrong += counts.distances > most[k] + 1;
            }
            CHECK_INT(0, wrong, "%s, at most %d steps",
                      distributions[d].name, (int)most[k]);
        }
        workspace_free(&workspace);
        points_free(&points);
    }
}

// Divide and conquer alone: log2 n joins of a few distances each, on
// whatever points.
static void halves_are_n_log_n(void)
{
    enum { N = 20000 };
    for (int d = 0; d < distribution_count; d++)
        for (int g = STANDARD; g <= WRAPAROUND; g++) {
            struct points points = generate(&distributions[d], N, 3);
            struct counts counts = {0};
            struct question question = question_of(points, g, 2);
            question.counts = &counts;
            struct workspace workspace = {0};
            struct answers found = answers_for(N, NEAREST);
            uint32_t *all = allocate(N, sizeof *all);
            for (uint32_t i = 0; i < N; i++)
                all[i] = i;
            search_divide_and_conquer(&question, all, N, &workspace,
                                      &found);
            CHECK(counts.distances < 4 * N * log2(N),
                  "%s, geometry %d: %g distances a point",
                  distributions[d].name, g,
                  (double)counts.distances / N);
            free(all);
            workspace_free(&workspace);
            answers_free(&found);
            points_free(&points);
        }
}

// ---- what the pieces promise ---------------------------------------
static bool holds(const struct box *box, double x, double y)
{
    return box->left <= x && x <= box->right && box->bottom <= y &&
           y <= box->top;
}

static void check_piece(const char *name, const struct piece *piece,
                        uint32_t *next)
{
    const struct points p = piece->sorted.points;
    bool inside = true;
    for (uint32_t s = 0; s < p.n; s++)
        inside &= holds(&piece->region, p.x[s], p.y[s]);
    CHECK(inside, "%s: a piece is in its region", name);
    CHECK_INT(*next, piece->begin, "%s: pieces follow each other",
              name);
    *next += p.n;
}

// A leaf has no more pieces than it has room for, and no piece is in
// the room of the next.
static void check_rooms(const char *name, const struct pieces *pieces)
{
    const double *border = NULL;
    const uint32_t *start = NULL;
    uint32_t crowded = 0, overlaps = 0;
    for (uint32_t k = 0; k < pieces->leaves; k++) {
        uint32_t points = 0;
        for (uint32_t i = 0; i < pieces->count[k]; i++) {
            const struct sorted *sorted =
                &pieces->piece[pieces->first[k] + i].sorted;
            const struct grid *grid = &sorted->grid;
            points += sorted->points.n;
            if (grid->x.count == 0) // a place
                continue;
            overlaps += border && grid->x.border < border;
            overlaps += start && sorted->cells.start < start;
            border = grid->y.border + grid->y.count + 1;
            start = sorted->cells.start + grid_cells(grid) + 1;
        }
        crowded += pieces->count[k] > piece_slots(points);
    }
    CHECK_INT(0, crowded, "%s: every piece has a slot", name);
    CHECK_INT(0, overlaps, "%s: every grid has room", name);
}

static void pieces_hold_all_points(void)
{
    enum { N = 30000 };
    for (int d = 0; d < distribution_count; d++) {
        const char *name = distributions[d].name;
        struct points points = generate(&distributions[d], N, 3);
        struct question question = question_of(points, STANDARD, 2);
        struct workspace workspace = {0};
        struct pieces pieces = pieces_make(&question, &workspace);
        uint32_t next = 0, wrong = 0;
        for (uint32_t k = 0; k < pieces.leaves; k++)
            for (uint32_t i = 0; i < pieces.count[k]; i++)
                check_piece(name, &pieces.piece[pieces.first[k] + i],
                            &next);
        CHECK_INT(N, next, "%s: all points are in pieces", name);
        check_rooms(name, &pieces);
        for (uint32_t s = 0; s < N; s++) {
            const uint32_t i = pieces.sorted.cells.point[s];
            wrong += pieces.permutation[i] != pieces.inverse[s] ||
                     points.x[i] != pieces.sorted.points.x[s] ||
                     points.y[i] != pieces.sorted.points.y[s];
        }
        CHECK_INT(0, wrong, "%s: each point is where it is said", name);
        workspace_free(&workspace);
        points_free(&points);
    }
}

// A list is parted near its middle, but equal values stay together.
static void cuts_are_balanced(void)
{
    enum { N = 1000 };
    static struct point_record record[N];
    static double value[N];
    static uint32_t list[N], number[N];
    for (int heavy = 0; heavy < 10; heavy++) {
        struct random random = {heavy};
        for (uint32_t k = 0; k < N; k++) {
            const bool same = (int)(random_bits(&random) % 10) < heavy;
            record[k].x = same ? 0.5 : random_uniform(&random);
            list[k] = k;
        }
        const struct box box = box_of(record, list, N);
        struct cut cut;
        const uint32_t first =
            cut_list(record, list, N, &box,
                     (struct cut_room){value, number}, &cut);
        uint32_t wrong = 0;
        for (uint32_t k = 0; k < N; k++)
            wrong += (record[list[k]].x < cut.at) != (k < first);
        CHECK_INT(0, wrong, "%d tenths equal: parted", heavy);
        CHECK(first > 0 && first < N, "%d tenths equal: both parts",
              heavy);
        CHECK(heavy > 6 || (first >= N / 8 && first <= N - N / 8),
              "%d tenths equal: %u", heavy, first);
    }
}

// ---- how deep the cuts go ------------------------------------------
// What chapter 11 proves of the cuts below m points.
static double deepest(double m)
{
    return m < FEWEST_TO_CUT
               ? 0
               : 3 * (log(m / FEWEST_TO_CUT) / log(9.0 / 8) + 3);
}

static uint32_t depth_of_node(const struct pieces *pieces, uint32_t k)
{
    const struct node *node = &pieces->node[k];
    if (node->first_child == 0)
        return 0;
    const uint32_t a = depth_of_node(pieces, node->first_child);
    const uint32_t b = depth_of_node(pieces, node->second_child);
    return 1 + MAX(a, b);
}

// However crowded or even the parts are.
static uint32_t depth_of_cuts(const struct point_record *record,
                              uint32_t *list, uint32_t n,
                              struct cut_room room)
{
    const struct box box = box_of(record, list, n);
    struct cut cut;
    if (n < FEWEST_TO_CUT || box_is_place(&box))
        return 0;
    const uint32_t first = cut_list(record, list, n, &box, room, &cut);
    const uint32_t a = depth_of_cuts(record, list, first, room);
    const uint32_t b =
        depth_of_cuts(record, list + first, n - first, room);
    return 1 + MAX(a, b);
}

static void check_depth(const char *name, struct points points)
{
    const uint32_t n = points.n;
    struct workspace workspace = {0};
    struct point_record *record =
        workspace_take(&workspace, n, sizeof *record);
    uint32_t *list = workspace_take(&workspace, n, sizeof *list);
    const struct cut_room room = {
        workspace_take(&workspace, n, sizeof(double)),
        workspace_take(&workspace, n, sizeof(uint32_t))};
    for (uint32_t i = 0; i < n; i++) {
        record[i] =
            (struct point_record){points.x[i], points.y[i], 0, i};
        list[i] = i;
    }
    const uint32_t cuts = depth_of_cuts(record, list, n, room);
    CHECK(cuts <= deepest(n), "%s: cuts on %u levels", name, cuts);
    struct question question = question_of(points, STANDARD, 1);
    const struct pieces pieces = pieces_make(&question, &workspace);
    const uint32_t depth = depth_of_node(&pieces, 0);
    CHECK(depth <= DEEPEST_LEAF + deepest(n), "%s: a tree of %u levels",
          name, depth);
    workspace_free(&workspace);
}

// Crosses in crosses: of those that are left, a share has the same x,
// another the same y.
static struct points crosses(uint32_t n, double share, uint64_t seed)
{
    struct points points =
        generate(find_distribution("uniform"), n, seed);
    struct random random = {seed};
    for (uint32_t i = 0; i < n; i++) {
        double scale = 1;
        while (random_uniform(&random) < 0.2)
            scale /= 4;
        points.x[i] *= scale, points.y[i] *= scale;
        if (random_uniform(&random) < share)
            points.x[i] = scale / 2;
        if (random_uniform(&random) < share)
            points.y[i] = scale / 2;
    }
    return points;
}

static void no_tree_is_deep(void)
{
    enum { N = 30000 };
    CHECK(DEEPEST_LEAF + deepest(UINT32_MAX) < DEEPEST,
          "a search has a stack for any number of points");
    for (int d = 0; d < distribution_count; d++) {
        struct points points = generate(&distributions[d], N, 3);
        check_depth(distributions[d].name, points);
        points_free(&points);
    }
    for (int tenths = 5; tenths < 10; tenths++) {
        test_seed(tenths);
        struct points points = crosses(N, tenths / 10.0, tenths);
        check_depth("crosses", points);
        points_free(&points);
    }
}

// The chapter's example: all but two of 32 points have the same x. Two
// cuts take these off, one each, and the next is along y.
static void bad_cuts_end(void)
{
    enum { N = 32 };
    struct point_record record[N];
    double values[N];
    uint32_t all[N], numbers[N];
    const struct cut_room room = {values, numbers};
    struct cut cut;
    for (uint32_t k = 0; k < N; k++) {
        const double x = k == 0 ? 2 : k == 1 ? 9 : 5;
        record[k] = (struct point_record){x, (double)k / N, 0, k};
        all[k] = k;
    }
    struct box box = box_of(record, all, N);
    CHECK_INT(1, cut_list(record, all, N, &box, room, &cut), "below");
    uint32_t *list = all + 1; // from here on the larger part
    box = box_of(record, list, N - 1);
    CHECK_INT(N - 2, cut_list(record, list, N - 1, &box, room, &cut),
              "above");
    CHECK(!cut.by_y, "both are along x");
    box = box_of(record, list, N - 2);
    cut_list(record, list, N - 2, &box, room, &cut);
    CHECK(box.left == box.right && cut.by_y, "and no other is");
}

// ---- who decides ---------------------------------------------------
static const char *choice(struct points points, unsigned answered)
{
    struct question question = question_of(points, STANDARD, 1);
    struct answers found = answers_for(points.n, answered);
    const char *name = "none";
    question.algorithm_name = &name;
    by_sample(&question, &found);
    answers_free(&found);
    return name;
}

static void even_points_get_a_grid(void)
{
    static const char *const even[] = {"uniform", "clustered",
                                       "lattice", "doubled", "thin"};
    const uint32_t sizes[] = {5000, 100000};
    for (int d = 0; d < distribution_count; d++)
        for (int k = 0; k < 2; k++) {
            const char *name = distributions[d].name;
            struct points points =
                generate(&distributions[d], sizes[k], 9);
            bool expected = false;
            for (int e = 0; e < 5; e++)
                expected |= strcmp(name, even[e]) == 0;
            CHECK_TEXT(expected ? "near-and-far" : "adaptive",
                       choice(points, NEAREST), "%u %s points",
                       points.n, name);
            points_free(&points);
        }
}

// A crowd in each coarse cell of the sample, which finds them even.
static struct points lattice_of_crowds(uint32_t n, int side)
{
    struct random random = {5};
    struct points points = points_allocate(n);
    for (uint32_t i = 0; i < n; i++) {
        const int crowd = i % (side * side);
        points.x[i] =
            (crowd % side + 1e-3 * random_uniform(&random)) / side;
        points.y[i] =
            (crowd / side + 1e-3 * random_uniform(&random)) / side;
    }
    return points;
}

// A disc of even points, and a tenth of all on its rim: all corners.
static struct points rimmed_disc(uint32_t n)
{
    struct random random = {6};
    struct points points = points_allocate(n);
    for (uint32_t i = 0; i < n; i++) {
        const double angle = 2 * acos(-1) * random_uniform(&random);
        const double radius =
            i % 10 == 0 ? 1 : 0.999 * sqrt(random_uniform(&random));
        points.x[i] = radius * cos(angle);
        points.y[i] = radius * sin(angle);
    }
    return points;
}

static void what_deceives_the_sample(void)
{
    struct points crowds = lattice_of_crowds(100000, 16);
    CHECK_TEXT("adaptive", choice(crowds, NEAREST),
               "what the sample lets pass is counted");
    points_free(&crowds);
    double each[2];
    for (int k = 0; k < 2; k++) {
        struct points disc = rimmed_disc(k ? 200000 : 50000);
        CHECK_TEXT("near-and-far", choice(disc, NEAREST), "a disc");
        each[k] = distances("by-sample", question_of(disc, STANDARD, 1),
                            NEAREST | FURTHEST);
        points_free(&disc);
    }
    CHECK(each[1] < 1.5 * each[0], "%.1f and %.1f distances", each[0],
          each[1]);
    struct points few = rimmed_disc(3000);
    check_points("rimmed disc", few, 2);
    points_free(&few);
}

// What a single grid could be hurt by: crowds of so many points in a
// cell each, on the left, as many as the limit of the density admits;
// around each of them lonely points at every distance, whose blocks
// grow until the crowd is in them; on the right even points.
static struct points lonely_among_crowds(uint32_t n, uint32_t crowd)
{
    struct random random = {crowd};
    struct points points = points_allocate(n);
    const double cell = sqrt(1.5 / n), turn = acos(-1) / 3;
    const uint32_t columns = MAX(1, sqrt(5.0 * n) / crowd);
    const double apart = 0.5 / columns;
    const uint32_t rows = MAX(1, (uint32_t)(1 / apart / 2));
    uint32_t i = 0;
    points.x[i] = 0, points.y[i++] = 0;
    points.x[i] = 1, points.y[i++] = 1;
    for (uint32_t k = 0; k < columns * rows; k++) {
        const double x = (k % columns + 0.5) * apart;
        const double y = (k / columns + 0.5) / rows;
        for (uint32_t c = 0; c < crowd && i < n; c++) {
            points.x[i] = x + cell / 9 * random_uniform(&random);
            points.y[i++] = y + cell / 9 * random_uniform(&random);
        }
        for (double r = 4 * cell; r < apart / 2; r *= 2)
            for (int a = 0; a < 6 && i < n; a++) {
                points.x[i] = x + r * cos(a * turn);
                points.y[i++] = y + r * sin(a * turn);
            }
    }
    for (; i < n; i++) {
        points.x[i] = 0.5 + random_uniform(&random) / 2;
        points.y[i] = random_uniform(&random);
    }
    return points;
}

// As the chapter proves, and far below.
static void lonely_points_do_not_hurt(void)
{
    static const uint32_t sizes[] = {20000, 200000};
    for (int kind = 0; kind < 3; kind++) {
        double each[2];
        for (int k = 0; k < 2; k++) {
            const uint32_t n = sizes[k];
            const uint32_t crowd = kind == 0   ? 32
                                   : kind == 1 ? 128
                                               : sqrt(5.0 * n);
            struct points points = lonely_among_crowds(n, crowd);
            CHECK_TEXT("near-and-far", choice(points, NEAREST),
                       "crowds of %u are let pass", crowd);
            each[k] = distances(
                "by-sample", question_of(points, STANDARD, 1), NEAREST);
            const double most = 192 + 34 * 10 + 74 * log2(n);
            CHECK(each[k] < most, "crowds of %u: %g distances", crowd,
                  each[k]);
            points_free(&points);
        }
        CHECK(each[1] < 1.5 * each[0], "kind %d: %g, then %g", kind,
              each[0], each[1]);
    }
}

// ---- arcs ----------------------------------------------------------
// Corners that are spread evenly on a circle. A search begins anywhere,
// and enters no more arcs than the chapter proves.
static void a_climb_enters_few_arcs(void)
{
    enum { QUERIES_ASKED = 2000 };
    for (uint32_t n = 1000; n <= 1000000; n *= 10) {
        struct points circle = points_allocate(n);
        struct workspace workspace = {0};
        uint32_t *number =
            workspace_take(&workspace, n, sizeof *number);
        for (uint32_t i = 0; i < n; i++) {
            circle.x[i] = cos(2 * acos(-1) * i / n);
            circle.y[i] = sin(2 * acos(-1) * i / n);
            number[i] = i;
        }
        const struct corners corners = {circle, number};
        const struct arcs arcs = arcs_make(&corners, &workspace);
        struct random random = {n};
        uint64_t all = 0, most = 0;
        for (int k = 0; k < QUERIES_ASKED; k++) {
            const double angle = 2 * acos(-1) * random_uniform(&random);
            const double radius = random_uniform(&random);
            struct arc_query query = {.x = radius * cos(angle),
                                      .y = radius * sin(angle),
                                      .corner =
                                          random_bits(&random) % n};
            arcs_furthest(&arcs, &query);
            all += query.compared;
            most = MAX(most, query.compared);
        }
        const uint64_t levels = (uint64_t)arcs.levels;
        CHECK(most <= 4 * (3 * levels * levels + 17 * levels),
              "%u corners: %g, at most %d", n,
              (double)all / QUERIES_ASKED, (int)most);
        workspace_free(&workspace);
        points_free(&circle);
    }
}

static void check_memory(search_function *search, struct points points)
{
    struct question question = question_of(points, WRAPAROUND, 2);
    struct workspace workspace = {0};
    question.workspace = &workspace;
    struct answers found = answers_for(points.n, NEAREST | FURTHEST);
    search(&question, &found);
    const struct workspace before = workspace;
    search(&question, &found);
    CHECK(memcmp(&before, &workspace, sizeof before) == 0,
          "the workspace is what it was");
    answers_free(&found);
    workspace_free(&workspace);
}

static void a_second_answer_takes_no_memory(void)
{
    for (int d = 0; d < distribution_count; d++) {
        struct points points = generate(&distributions[d], 20000, 9);
        check_memory(adaptive, points);
        check_memory(by_sample, points);
        points_free(&points);
    }
}

int main(void)
{
    return RUN_TESTS(
        "ch11", TEST(every_generator), TEST(tens_of_thousands),
        TEST(moved_and_stretched), TEST(ties),
        TEST(no_crowd_is_quadratic), TEST(distances_are_predicted),
        TEST(threads_count_alike), TEST(queries_keep_to_their_steps),
        TEST(halves_are_n_log_n), TEST(pieces_hold_all_points),
        TEST(cuts_are_balanced), TEST(no_tree_is_deep),
        TEST(bad_cuts_end), TEST(even_points_get_a_grid),
        TEST(what_deceives_the_sample), TEST(lonely_points_do_not_hurt),
        TEST(a_climb_enters_few_arcs),
        TEST(a_second_answer_takes_no_memory));
}
