//> Let bodies sleep
// Whatever sleeps or wakes, nothing crosses: a body that sleeps stays,
// and pairs in which something moves are searched as ever. Only how a
// heap looks depends on it. A step costs time in proportion to the
// bodies and the contacts.
#include "ch13-contact/sleep.h"
#include "ch13-contact/vectors.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

//> Set up the sleepers
struct sleepers sleepers_of(const struct scene *scene,
                            uint32_t patience)
{
    struct sleepers sleepers = {
        .rest = allocate(scene->bodies, sizeof(struct rest)),
        .patience = patience};
    for (uint32_t b = 0; b < scene->bodies; b++) {
        const struct body *body = &scene->body[b];
        double reach2 = 0;
        for (uint32_t i = body->begin.node; i < body->end.node; i++) {
            const double local[3] = {scene->local[0][i],
                                     scene->local[1][i],
                                     scene->local[2][i]};
            reach2 = MAX(reach2, dot(local, local));
        }
        sleepers.rest[b] = (struct rest){.pose = pose_after(body, 0),
                                         .reach = sqrt(reach2)};
    }
    return sleepers;
}

void sleepers_free(struct sleepers *sleepers)
{
    free(sleepers->rest);
    *sleepers = (struct sleepers){0};
}
//<

//> See whether a body has left its place
// By more than LEEWAY, a share of its reach. Two quaternions that
// differ by d turn a node to places that are at most 2 d times the
// reach apart.
static const double LEEWAY = 0.01;

static bool has_left(const struct body *body, const struct rest *rest)
{
    double way2 = 0, turn2 = 0;
    for (int k = 0; k < 3; k++) {
        const double way = body->position[k] - rest->pose.position[k];
        way2 += way * way;
    }
    for (int k = 0; k < 4; k++) {
        const double turn =
            body->orientation[k] - rest->pose.orientation[k];
        turn2 += turn * turn;
    }
    return sqrt(way2) + 2 * rest->reach * sqrt(turn2) >
           LEEWAY * rest->reach;
}
//<

//> Fall asleep
// What flies freely touches nothing, and does not sleep however slow it
// is.
static void fall_asleep(struct sleepers *sleepers, struct body *body,
                        struct rest *rest)
{
    if (has_left(body, rest)) {
        rest->pose = pose_after(body, 0);
        rest->steps = 0;
    }
    rest->steps += rest->touched;
    rest->touched = false;
    if (rest->steps < sleepers->patience)
        return;
    body->motion = ASLEEP;
    memset(body->velocity, 0, sizeof body->velocity);
    memset(body->angular_velocity, 0, sizeof body->angular_velocity);
    sleepers->asleep++;
}
//<

//> Wake what is touched
// By something that has just left its place. What wakes has rested for
// all steps but a few: so it does not wake its neighbors in turn unless
// it leaves its place, and if it stays, it soon sleeps again.
enum { RECENT = 2, AGAIN = 4 };

static void wake(struct sleepers *sleepers, struct scene *scene,
                 uint32_t b, uint32_t by)
{
    if (scene->body[b].motion != ASLEEP || is_held(&scene->body[by]) ||
        sleepers->rest[by].steps >= RECENT)
        return;
    scene->body[b].motion = RIGID;
    sleepers->rest[b].steps = sleepers->patience - AGAIN;
    sleepers->asleep--;
}
//<

//> Sleep or wake
void sleep_or_wake(struct sleepers *sleepers, struct scene *scene,
                   const struct contact_cache *cache)
{
    uint32_t two[2];
    assert(sleepers->patience == 0 || sleepers->patience > AGAIN);
    if (sleepers->patience == 0)
        return;
    for (uint32_t c = 0; c < cache->count; c++) {
        bodies_of_contact(&cache->contact[c], scene, two);
        for (int k = 0; k < 2; k++)
            sleepers->rest[two[k]].touched = true;
    }
    for (uint32_t b = 0; b < scene->bodies; b++)
        if (scene->body[b].motion == RIGID)
            fall_asleep(sleepers, &scene->body[b], &sleepers->rest[b]);
    for (uint32_t c = 0; c < cache->count; c++) {
        bodies_of_contact(&cache->contact[c], scene, two);
        wake(sleepers, scene, two[0], two[1]);
        wake(sleepers, scene, two[1], two[0]);
    }
}
//<
//<
