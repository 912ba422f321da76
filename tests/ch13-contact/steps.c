// Scenes in motion: nothing is missed, and nothing crosses.
#include "ch13-contact/exact.h"
#include "ch13-contact/motion.h"
#include "ch13-contact/scenes.h"
#include "ch13-contact/separating_axis.h"
#include "ch13-contact/shapes.h"
#include "ch13-contact/step.h"
#include "common/random.h"
#include "parts.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct simulation simulate(const char *scene, uint32_t size,
                                  const char *broad, int threads)
{
    const struct built_in *kind = find_built_in(scene);
    return simulation_of(build_scene(kind, size, 2),
                         find_broad_phase(broad), kind->dt, threads);
}

static bool same_events(const struct events *a, const struct events *b)
{
    if (a->all.count != b->all.count)
        return false;
    for (uint64_t e = 0; e < a->all.count; e++) {
        const struct event *x = &a->all.event[e];
        const struct event *y = &b->all.event[e];
        if (compare_features(x, y) != 0 || x->time != y->time ||
            memcmp(x->weight, y->weight, sizeof x->weight) != 0 ||
            memcmp(x->point, y->point, sizeof x->point) != 0)
            return false;
    }
    return true;
}

// Every pair of triangles that could touch, whatever the boxes say.
static void pair_all(const struct scene *scene, struct pairs *pairs)
{
    pairs_begin(pairs, 1);
    const uint32_t n = scene->mesh.triangles;
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i + 1; j < n; j++)
            if (scene->group[i] != scene->group[j] ||
                scene->group[i] == NO_INDEX)
                pair_add(&pairs->list[0], i, j);
    pairs_gather(pairs, n);
}

static void compare_with_all_pairs(struct simulation *s,
                                   const char *name, double tolerance)
{
    struct pairs pairs = {0};
    struct events all = {0}, found = {0};
    s->tolerance = tolerance;
    s->passive = true;
    take_step(s); // moves; then the next step, but not to its end
    scene_predict(&s->scene, s->dt, 1);
    capture(&s->boxes, &s->scene, tolerance, 1);
    const struct broad_search search = {&s->boxes, s->scene.group,
                                        &s->pairs, 1};
    find_pairs(s->broad_phase, s->kept, &search);
    pair_all(&s->scene, &pairs);
    memset(s->stopped_in_round, 0,
           s->scene.mesh.nodes * sizeof *s->stopped_in_round);
    struct event_search of = {.scene = &s->scene,
                              .pairs = &pairs,
                              .tolerance = tolerance,
                              .stopped_in_round = s->stopped_in_round,
                              .round = 1,
                              .threads = 1};
    find_events(&all, &of);
    of.pairs = &s->pairs;
    find_events(&found, &of);
    CHECK(same_events(&all, &found),
          "%s, tolerance %g: %u events of %u", name, tolerance,
          (unsigned)found.all.count, (unsigned)all.all.count);
    pairs_free(&pairs);
    events_free(&all);
    events_free(&found);
}

void boxes_hold_all_events(void)
{
    static const char *const names[] = {"cloud", "rings", "cloth",
                                        "bullet"};
    static const uint32_t sizes[] = {8, 8, 8, 6};
    for (int k = 0; k < 4; k++)
        for (int step = 0; step < 2; step++) {
            struct simulation s =
                simulate(names[k], sizes[k], "clusters", 1);
            s.dt *= 8;
            compare_with_all_pairs(&s, names[k], step ? 0.05 : 1e-9);
            simulation_free(&s);
        }
}

// What the proof in boxes.c asks for.
void boxes_have_their_margin(void)
{
    struct simulation s = simulate("cloud", 8, "clusters", 1);
    scene_predict(&s.scene, 0.5, 1);
    for (int tight = 0; tight < 2; tight++) {
        const double tolerance = tight ? 1e-12 : 0.05;
        capture(&s.boxes, &s.scene, tolerance, 1);
        for (uint32_t t = 0; t < s.boxes.n; t++) {
            double margin = INFINITY, width = 0;
            for (int k = 0; k < 3; k++) {
                double low = INFINITY, high = -INFINITY;
                for (int c = 0; c < 6; c++) {
                    const double *x = c < 3 ? s.scene.mesh.x[k]
                                            : s.scene.predicted[k];
                    const uint32_t i = s.scene.mesh.corner[t][c % 3];
                    low = fmin(low, x[i]);
                    high = fmax(high, x[i]);
                }
                margin = fmin(margin, low - s.boxes.low[k][t]);
                margin = fmin(margin, s.boxes.high[k][t] - high);
                width = fmax(width, high - low);
            }
            CHECK(margin >= 0.5 * tolerance + 0x1p-29 * width,
                  "box %u: margin %g at width %g", t, margin, width);
        }
    }
    simulation_free(&s);
}

// Random triangles, near each other, some of them flat or equal.
static void draw_triangle(struct moving_triangle *t, uint32_t node,
                          double reach, struct random *random)
{
    for (int c = 0; c < 3; c++) {
        t->node[c] = node + c;
        for (int k = 0; k < 3; k++) {
            t->corner[c].begin[k] = random_uniform(random);
            t->corner[c].end[k] =
                t->corner[c].begin[k] +
                reach * (random_uniform(random) - 0.5);
        }
    }
    if (random_bits(random) % 8 == 0)
        t->corner[2] = t->corner[1];
    if (random_bits(random) % 8 == 0)
        for (int c = 0; c < 3; c++)
            t->corner[c].begin[2] = t->corner[c].end[2] = 0.5;
}

void apart_means_no_event(void)
{
    const uint32_t cases = at_most("MOST_CASES", 20000);
    struct random random = {5};
    uint32_t told = 0, without = 0;
    for (uint32_t k = 0; k < cases; k++) {
        struct moving_triangle p, q;
        struct event event[MAX_EVENTS];
        const double reach = k % 3 * 0.2;
        const double tolerance = k % 2 ? 1e-9 : 0.03;
        draw_triangle(&p, 0, reach, &random);
        draw_triangle(&q, 3, reach, &random);
        const bool apart = has_separating_axis(&p, &q, tolerance);
        const size_t count = triangle_events(&p, &q, tolerance, event,
                                             &(struct event_counts){0});
        CHECK(!apart || count == 0, "case %u", k);
        told += apart;
        without += count == 0;
    }
    CHECK(told > without / 2, "%u of %u are told", told, without);
}

void threads_find_the_same(void)
{
    struct simulation one = simulate("pile", 30, "clusters", 1);
    struct simulation two = simulate("pile", 30, "kd-tree", 2);
    struct simulation four = simulate("pile", 30, "sweep", 4);
    struct simulation *all[] = {&one, &two, &four};
    for (int step = 0; step < 60; step++) {
        for (int k = 0; k < 3; k++)
            take_step(all[k]);
        CHECK(same_events(&one.events, &two.events) &&
                  same_events(&one.events, &four.events),
              "step %d", step);
    }
    for (int k = 0; k < 3; k++)
        CHECK(memcmp(one.scene.mesh.x[k], two.scene.mesh.x[k],
                     one.scene.mesh.nodes * sizeof(double)) == 0,
              "coordinate %d after 60 steps", k);
    for (int k = 0; k < 3; k++)
        simulation_free(all[k]);
}

// Falls, touches, rests: few contacts at first, many in the end, and
// what has come down moves no more.
static double highest(const struct scene *scene)
{
    double highest = 0;
    for (uint32_t b = 0; b < scene->bodies; b++)
        if (scene->body[b].motion != FIXED &&
            scene->body[b].position[2] > highest)
            highest = scene->body[b].position[2];
    return highest;
}

void a_pile_stays_apart(void)
{
    const uint32_t steps = at_most("MOST_CASES", 400);
    struct simulation s = simulate("pile", 40, "clusters", 1);
    uint64_t candidates[2] = {0};
    const double begin = highest(&s.scene);
    for (uint32_t step = 0; step < steps; step++) {
        const struct step_report report = take_step(&s);
        candidates[step >= steps / 2] += report.candidates;
        CHECK_INT(0, count_crossing(&s), "step %u", step);
    }
    CHECK(2 * candidates[1] > 3 * candidates[0],
          "candidates: %u, then %u", (unsigned)candidates[0],
          (unsigned)candidates[1]);
    CHECK(steps < 400 || highest(&s.scene) < 0.7 * begin,
          "from %g down to %g", begin, highest(&s.scene));
    CHECK(highest(&s.scene) < 1.2 * begin, "nothing flies off");
    simulation_free(&s);
}

void a_ball_comes_to_rest(void)
{
    struct simulation s = simulate("pile", 1, "clusters", 1);
    double place[3] = {0};
    for (int step = 0; step < 600; step++) {
        if (step == 500)
            memcpy(place, s.scene.body[5].position, sizeof place);
        take_step(&s);
    }
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(place[k], s.scene.body[5].position[k], 0.02,
                   "coordinate %d", k);
    CHECK(place[2] > 0.2 && place[2] < 1, "on the floor: %g", place[2]);
    simulation_free(&s);
}

void a_bullet_is_stopped(void)
{
    struct simulation s = simulate("bullet", 8, "clusters", 1);
    uint64_t events = 0;
    for (int step = 0; step < 8; step++)
        events += take_step(&s).events;
    CHECK(events > 0, "events");
    CHECK(s.scene.body[1].position[2] > 0, "before the sheet: %g",
          s.scene.body[1].position[2]);
    simulation_free(&s);

    s = simulate("bullet", 8, "clusters", 1);
    s.passive = true;
    for (int step = 0; step < 8; step++) {
        const double before = s.scene.body[1].position[2];
        const struct step_report report = take_step(&s);
        const double after = s.scene.body[1].position[2];
        if (before * after < 0)
            CHECK(report.events > 0, "found in step %d", step);
        CHECK_INT(0, count_crossing(&s), "step %d", step);
    }
    CHECK(s.scene.body[1].position[2] < 0, "behind the sheet");
    simulation_free(&s);
}

void a_resting_cloth_has_no_contact(void)
{
    struct scene scene = {0};
    const struct mesh_mark since = mesh_mark(&scene.mesh);
    add_square_sheet(&scene.mesh, 10);
    scene_add(&scene, since, &(struct initial_state){SOFT});
    scene_complete(&scene);
    struct simulation s =
        simulation_of(scene, find_broad_phase("kd-tree"), 0.01, 1);
    const struct step_report report = take_step(&s);
    CHECK(report.candidates >= 200, "neighbors are candidates");
    CHECK_INT(0, report.events, "and touch nothing");
    simulation_free(&s);
}

void a_folding_cloth_has_contacts(void)
{
    struct simulation s = simulate("cloth", 14, "clusters", 1);
    uint64_t events = 0;
    for (int step = 0; step < 45; step++) {
        events += take_step(&s).events;
        if (step % 10 == 9)
            CHECK_INT(0, count_crossing(&s), "step %d", step);
    }
    CHECK(events > 0, "with itself");
    simulation_free(&s);
}

// A quarter of a turn in small steps; and no step changes a body.
void bodies_turn(void)
{
    struct scene scene = {0};
    const struct mesh_mark since = mesh_mark(&scene.mesh);
    add_box(&scene.mesh, 1);
    scene_add(&scene, since,
              &(struct initial_state){
                  RIGID, 0.5, .angular_velocity = {0, 0, acos(0)}});
    scene_complete(&scene);
    struct simulation s =
        simulation_of(scene, find_broad_phase("clusters"), 1e-3, 1);
    for (int step = 0; step < 1000; step++)
        take_step(&s);
    const struct mesh *m = &s.scene.mesh;
    for (uint32_t i = 0; i < m->nodes; i++) {
        const double *local[] = {s.scene.local[0], s.scene.local[1],
                                 s.scene.local[2]};
        CHECK_NEAR(-local[1][i], m->x[0][i], 1e-5, "x of node %u", i);
        CHECK_NEAR(local[0][i], m->x[1][i], 1e-5, "y of node %u", i);
        CHECK_NEAR(local[2][i], m->x[2][i], 1e-5, "z of node %u", i);
    }
    simulation_free(&s);
}

// Two boxes that go apart, with so much between them: how far the
// second one gets.
static double way_of_near_boxes(double gap)
{
    struct scene scene = {0};
    for (int k = 0; k < 2; k++) {
        const struct mesh_mark since = mesh_mark(&scene.mesh);
        const double side = k ? 1 : -1;
        add_box(&scene.mesh, 1);
        scene_add(&scene, since,
                  &(struct initial_state){
                      RIGID, 1, .position = {side * (1 + gap / 2)},
                      .velocity = {side}});
    }
    scene_complete(&scene);
    struct simulation s =
        simulation_of(scene, find_broad_phase("clusters"), 0.01, 1);
    CHECK_INT(0, count_crossing(&s), "at first");
    const double begin = s.scene.body[1].position[0];
    for (int step = 0; step < 10; step++)
        take_step(&s);
    const double way = s.scene.body[1].position[0] - begin;
    simulation_free(&s);
    return way;
}

// As the manual of contact says of --tolerance.
void near_bodies_stay(void)
{
    CHECK_NEAR(0.1, way_of_near_boxes(0x1p-33), 1e-9,
               "within the tolerance");
    CHECK(way_of_near_boxes(0x1p-46) == 0, "as near as rounding");
}
