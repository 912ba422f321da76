// The distance is chosen, and the right answers are known, by this
// book's k-d tree; boxes lie around points.
#include "peers/range_scene.h"
#include "ch04-cell-sort/line.h"
#include "ch12-range-queries/generate_set.h"
#include "common/experiment.h"
#include <inttypes.h>
#include <math.h>

// That at which half of the points have all the neighbors wanted.
static void choose_distance(struct range_scene *scene)
{
    const uint32_t n = scene->points.n;
    const struct structure *s = find_structure("kd-tree");
    void *built = s->build(&scene->points, 1);
    k_nearest_of_all(s, built, NEIGHBORS_WANTED, 1, scene->nearest,
                     scene->right2);
    s->discard(built);
    for (uint32_t i = 0; i < n; i++)
        scene->distance2[i] =
            scene->right2[(i + (size_t)1) * NEIGHBORS_WANTED - 1];
    sort_numbers(scene->distance2, n);
    // A little more, since libraries differ on whether it belongs to
    // it.
    scene->distance = sqrt(scene->distance2[n / 2]) * (1 + 1e-9);
}

// Around points; four times as wide as the distance.
static void draw_boxes(struct range_scene *scene)
{
    const struct point_set *p = &scene->points;
    struct random random = {17};
    for (uint32_t q = 0; q < BOX_COUNT; q++) {
        const uint32_t i = random_bits(&random) % p->n;
        double *row = scene->box + (size_t)q * 2 * p->d;
        for (int k = 0; k < p->d; k++) {
            row[k] = p->x[k][i] - 2 * scene->distance;
            row[p->d + k] = p->x[k][i] + 2 * scene->distance;
        }
    }
}

struct range_scene range_scene_of(const char *kind, uint32_t n, int d)
{
    struct range_scene scene = {
        generate_set(find_distribution(kind), n, d, 1)};
    scene.row = take((size_t)n * d, sizeof(double));
    for (int k = 0; k < d; k++)
        for (uint32_t i = 0; i < n; i++)
            scene.row[(size_t)i * d + k] = scene.points.x[k][i];
    scene.box = take((size_t)BOX_COUNT * 2 * d, sizeof(double));
    scene.nearest =
        take((size_t)n * NEIGHBORS_WANTED, sizeof(uint32_t));
    scene.nearest2 = take((size_t)n * NEIGHBORS_WANTED, sizeof(double));
    scene.right2 = take((size_t)n * NEIGHBORS_WANTED, sizeof(double));
    scene.found = take(n, sizeof(uint32_t));
    scene.distance2 = take(n, sizeof(double));
    scene.neighbor = take(n, sizeof(struct found));
    choose_distance(&scene);
    draw_boxes(&scene);
    return scene;
}

void compare_answers(const char *program, const struct range_run *run,
                     const struct range_scene *scene)
{
    const size_t count = (size_t)scene->points.n * NEIGHBORS_WANTED;
    for (size_t i = 0; run->ns[NEAREST_ONES] > 0 && i < count; i++)
        if (!(fabs(scene->nearest2[i] - scene->right2[i]) <=
              1e-12 * scene->right2[i]))
            fail("%s: neighbor %zu of point %zu is at %.17g, and not "
                 "at %.17g",
                 program, i % NEIGHBORS_WANTED, i / NEIGHBORS_WANTED,
                 sqrt(scene->nearest2[i]), sqrt(scene->right2[i]));
    if (run->ns[ALL_WITHIN] > 0 &&
        fabs((double)run->within - scene->within) >
            1e-6 * scene->within)
        fail("%s: %" PRIu64 " points within %g, and not %" PRIu64,
             program, run->within, scene->distance, scene->within);
    if (run->ns[IN_BOXES] > 0 && run->in_boxes != scene->in_boxes)
        fail("%s: %" PRIu64 " points in boxes, and not %" PRIu64,
             program, run->in_boxes, scene->in_boxes);
}
