// Questions about ranges by the structures of chapter 12 and by four
// libraries, and in the plane by near -k, one thread: the time to
// build, and for each query the time to find the 8 nearest, all within
// a distance that has about as many, and the points in boxes. POINTS
// points in two and three dimensions; each point asks. The answers are
// compared. SciPy is left out where there is none.
//     ranges [POINTS [TRIALS]]
#include "ch12-range-queries/structures.h"
#include "common/experiment.h"
#include "peers/range_peer.h"
#include "peers/range_plane.h"
#include "peers/range_scene.h"
#include "peers/range_scipy.h"

enum { MAX_TRIALS = 20 };

static const char *const kinds[] = {"uniform", "clustered", "kuzmin"};
static const char *const ours[] = {"kd-tree", "cells",
                                   "orthotree-compressed"};
static const struct range_peer *const peers[] = {
    &range_nanoflann, &range_boost, &range_cgal};

static struct range box_of_row(const double *row, int d)
{
    struct range range = {0};
    memcpy(range.low, row, d * sizeof *row);
    memcpy(range.high, row + d, d * sizeof *row);
    return range;
}

static uint64_t within_ours(const struct structure *s,
                            const void *built,
                            struct range_scene *scene)
{
    const struct sorted_points *sorted = s->walk_order(built);
    uint64_t count = 0;
    for (uint32_t i = 0; i < sorted->points.n; i++) {
        double place[MAX_DIMENSIONS];
        for (int k = 0; k < sorted->points.d; k++)
            place[k] = sorted->points.x[k][i];
        struct neighbor_query query = {
            .at = place, .self = NO_INDEX, .found = scene->neighbor};
        want_within(&query, scene->distance);
        s->neighbors(built, &query);
        count += query.count;
    }
    return count;
}

static uint64_t boxes_ours(const struct structure *s, const void *built,
                           const struct range_scene *scene)
{
    const int d = scene->points.d;
    uint64_t count = 0;
    for (uint32_t q = 0; q < BOX_COUNT; q++) {
        const struct range range =
            box_of_row(scene->box + (size_t)q * 2 * d, d);
        struct report report = {scene->found};
        s->query(built, &range, &report);
        count += report.count;
    }
    return count;
}

static struct range_run run_ours(const struct structure *s,
                                 struct range_scene *scene)
{
    const double n = scene->points.n;
    struct range_run run = {0};
    int64_t start = clock_ns();
    void *built = s->build(&scene->points, 1);
    run.ns[BUILD] = clock_ns() - start;
    if (s->neighbors) {
        start = clock_ns();
        k_nearest_of_all(s, built, NEIGHBORS_WANTED, 1, scene->nearest,
                         scene->nearest2);
        run.ns[NEAREST_ONES] = (clock_ns() - start) / n;
        start = clock_ns();
        run.within = within_ours(s, built, scene);
        run.ns[ALL_WITHIN] = (clock_ns() - start) / n;
    }
    start = clock_ns();
    run.in_boxes = boxes_ours(s, built, scene);
    run.ns[IN_BOXES] = (clock_ns() - start) / (double)BOX_COUNT;
    s->discard(built);
    return run;
}

static struct range_run run_peer(const struct range_peer *peer,
                                 struct range_scene *scene)
{
    const double n = scene->points.n;
    struct range_run run = {0};
    int64_t start = clock_ns();
    void *built =
        peer->build(scene->row, scene->points.n, scene->points.d);
    run.ns[BUILD] = clock_ns() - start;
    start = clock_ns();
    peer->nearest(built, NEIGHBORS_WANTED, scene->nearest,
                  scene->nearest2);
    run.ns[NEAREST_ONES] = (clock_ns() - start) / n;
    start = clock_ns();
    run.within = peer->within(built, scene->distance);
    run.ns[ALL_WITHIN] = (clock_ns() - start) / n;
    if (peer->boxes) {
        start = clock_ns();
        run.in_boxes = peer->boxes(built, scene->box, BOX_COUNT);
        run.ns[IN_BOXES] = (clock_ns() - start) / (double)BOX_COUNT;
    }
    peer->discard(built);
    return run;
}

static struct range_run run_plane(struct range_scene *scene)
{
    const double n = scene->points.n;
    struct plane_times times;
    struct range_run run = {.within = answer_in_plane(scene, &times)};
    run.ns[BUILD] = times.build;
    run.ns[NEAREST_ONES] = times.nearest / n;
    run.ns[ALL_WITHIN] = times.within / n;
    return run;
}

// One of the three is not NULL.
struct program {
    const char *name;
    const struct structure *structure;
    const struct range_peer *peer;
    struct range_run (*run)(struct range_scene *scene);
};

static struct range_run run_program(const struct program *program,
                                    struct range_scene *scene)
{
    if (program->structure)
        return run_ours(program->structure, scene);
    return program->peer ? run_peer(program->peer, scene)
                         : program->run(scene);
}

static void print_program(const struct program *program,
                          const char *kind, struct range_scene *scene,
                          int trials)
{
    const char *name = program->name;
    double ns[TASKS][MAX_TRIALS];
    for (int trial = -1; trial < trials; trial++) {
        const struct range_run run = run_program(program, scene);
        compare_answers(name, &run, scene);
        for (int q = 0; q < TASKS && trial >= 0; q++)
            ns[q][trial] = run.ns[q];
    }
    row_begin("%s_%s_%d\t%s\t%s\t%d\t%u", name, kind, scene->points.d,
              name, kind, scene->points.d, scene->points.n);
    for (int q = 0; q < TASKS; q++) {
        const struct summary summary = summarize(ns[q], trials);
        row_times(&summary, q == BUILD ? scene->points.n : 1);
    }
    row_end();
}

// The first structure's answers are taken to be right.
static void take_as_right(struct range_scene *scene)
{
    const struct range_run run =
        run_ours(find_structure(ours[0]), scene);
    scene->within = run.within;
    scene->in_boxes = run.in_boxes;
}

// Cells take hours where one of them has most of a million points.
static bool is_bearable(const char *name, const char *kind)
{
    return strcmp(name, "cells") != 0 || strcmp(kind, "kuzmin") != 0;
}

static void print_all(const char *kind, struct range_scene *scene,
                      bool scipy, int trials)
{
    for (int k = 0; k < COUNT_OF(ours); k++)
        if (is_bearable(ours[k], kind))
            print_program(
                &(struct program){ours[k],
                                  .structure = find_structure(ours[k])},
                kind, scene, trials);
    if (scene->points.d == 2)
        print_program(&(struct program){"near-k", .run = run_plane},
                      kind, scene, trials);
    for (int k = 0; k < COUNT_OF(peers); k++)
        print_program(
            &(struct program){peers[k]->name, .peer = peers[k]}, kind,
            scene, trials);
    if (scipy)
        print_program(&(struct program){"SciPy", .run = run_scipy},
                      kind, scene, trials);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "POINTS", 10000, 100, MANY);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    const bool scipy = scipy_is_there();
    print_header(&e, "name program kind d n build:3 nearest:3 within:3 "
                     "boxes:3");
    for (int d = 2; d <= 3; d++)
        for (int kind = 0; kind < COUNT_OF(kinds); kind++) {
            struct range_scene scene =
                range_scene_of(kinds[kind], n, d);
            take_as_right(&scene);
            print_all(kinds[kind], &scene, scipy, trials);
            point_set_free(&scene.points);
            forget();
        }
}
