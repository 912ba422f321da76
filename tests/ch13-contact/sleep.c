// What has come to rest sleeps, and wakes when it should.
#include "ch13-contact/scenes.h"
#include "ch13-contact/shapes.h"
#include "ch13-contact/step.h"
#include "parts.h"

static void put(struct scene *scene, bool ball, double size,
                double height)
{
    const struct mesh_mark since = mesh_mark(&scene->mesh);
    if (ball)
        add_sphere(&scene->mesh, 1);
    else
        add_box(&scene->mesh, 1);
    scene_add(scene, since,
              &(struct initial_state){
                  RIGID, size, .position = {0.01, 0.02, height}});
}

// A box of height 1 over a floor, and a ball or another box above it.
static struct simulation over_a_floor(bool ball, double size,
                                      double height)
{
    struct scene scene = {.gravity = {0, 0, -10}};
    const struct mesh_mark since = mesh_mark(&scene.mesh);
    add_square_sheet(&scene.mesh, 1);
    scene_add(&scene, since, &(struct initial_state){FIXED, 9});
    put(&scene, false, 0.5, 0.6);
    put(&scene, ball, size, height);
    scene_complete(&scene);
    return simulation_of(scene, find_broad_phase("clusters"), 0.01, 1);
}

void a_blow_wakes_a_body(void)
{
    struct simulation s = over_a_floor(true, 0.3, 12);
    const struct body *box = &s.scene.body[1];
    const struct body *ball = &s.scene.body[2];
    for (int step = 0; step < 100; step++)
        take_step(&s);
    CHECK_INT(ASLEEP, box->motion, "on the floor");
    CHECK_INT(RIGID, ball->motion, "in the air");
    CHECK_INT(1, s.sleepers.asleep, "one sleeps");
    bool woke = false;
    for (int step = 0; step < 150; step++) {
        take_step(&s);
        woke |= box->motion == RIGID;
        CHECK_INT(0, count_crossing(&s), "step %d", step);
    }
    CHECK(woke, "the ball has hit the box");
    CHECK(ball->position[2] > 0.2, "and not gone through: %g",
          ball->position[2]);
    simulation_free(&s);
}

void what_falls_does_not_sleep(void)
{
    struct simulation s = over_a_floor(true, 0.3, 900);
    const struct body *ball = &s.scene.body[2];
    s.scene.gravity[2] = -1e-6; // all but nothing
    for (int step = 0; step < 300; step++)
        take_step(&s);
    CHECK_INT(RIGID, ball->motion, "slow, and touches nothing");
    simulation_free(&s);
}

void a_body_wakes_when_its_support_goes(void)
{
    struct simulation s = over_a_floor(false, 0.5, 1.65);
    struct body *lower = &s.scene.body[1], *upper = &s.scene.body[2];
    for (int step = 0; step < 150; step++)
        take_step(&s);
    CHECK_INT(2, s.sleepers.asleep, "two boxes");
    const double height = upper->position[2];
    CHECK(height > 1.4, "one on the other: %g", height);

    lower->motion = RIGID;
    lower->velocity[0] = 30;
    s.sleepers.rest[1].steps = 0;
    s.sleepers.asleep--;
    for (int step = 0; step < 100; step++) {
        take_step(&s);
        CHECK_INT(0, count_crossing(&s), "step %d", step);
    }
    CHECK(upper->position[2] < height - 0.5, "it has come down: %g",
          upper->position[2]);
    simulation_free(&s);
}

void a_heap_rests_for_long(void)
{
    const uint32_t steps = at_most("MOST_CASES", 3000);
    const struct built_in *pile = find_built_in("pile");
    struct simulation s =
        simulation_of(build_scene(pile, 10, 2),
                      find_broad_phase("clusters"), pile->dt, 1);
    uint64_t awake = 0, pairs = 0;
    for (uint32_t step = 1; step <= steps; step++) {
        const struct step_report report = take_step(&s);
        if (step % 10 == 0)
            CHECK_INT(0, count_crossing(&s), "step %u", step);
        if (step > 2000) {
            awake += 10 - report.asleep;
            pairs += report.candidates - report.paired;
        }
    }
    CHECK(steps < 3000 || awake < 3000, "of 10000: %u are awake",
          (unsigned)awake);
    CHECK(steps < 3000 || pairs > 0, "pairs that sleep are left out");
    simulation_free(&s);
}

// With patience 0 all is as if there were no sleep.
void none_sleeps_without_patience(void)
{
    struct simulation s = over_a_floor(false, 0.5, 1.65);
    s.sleepers.patience = 0;
    for (int step = 0; step < 100; step++) {
        const struct step_report report = take_step(&s);
        CHECK_INT(0, report.asleep, "step %d", step);
        CHECK_INT(report.candidates, report.paired, "step %d", step);
    }
    simulation_free(&s);
}
