//> Advance bodies by steps
// What has an event stays where it was; that may be in the way of what
// moves, and so it goes on, in rounds, until nothing that moves has an
// event. In the worst case nothing moves at all, and what was apart is
// apart. Boxes over the whole step hold a body that stays as well: the
// candidates are found once, and a further round costs no more than to
// search again those in which something has just come to rest.
#include "ch13-contact/step.h"
#include "ch13-contact/motion.h"
#include "ch13-contact/static_test.h"
#include "common/allocate.h"
#include "common/clock.h"
#include <stdlib.h>
#include <string.h>

//> Set up a simulation
// For the contact cache and for sleep: what their fields say.
static const double FRICTION = 0.4;
enum { MAX_AGE = 8, ROUNDS = 10, PATIENCE = 16 };

struct simulation simulation_of(struct scene scene,
                                const struct broad_phase *phase,
                                double dt, int threads)
{
    return (struct simulation){
        .scene = scene,
        .broad_phase = phase,
        .kept = phase->begin(phase),
        .dt = dt,
        .tolerance = DEFAULT_TOLERANCE,
        .threads = threads,
        .contacts = {.friction = FRICTION,
                     .max_age = MAX_AGE,
                     .rounds = ROUNDS},
        .sleepers = sleepers_of(&scene, PATIENCE),
        .stopped_in_round =
            allocate(scene.mesh.nodes, sizeof(uint32_t))};
}

void simulation_free(struct simulation *s)
{
    s->broad_phase->end(s->kept);
    scene_free(&s->scene);
    boxes_free(&s->boxes);
    pairs_free(&s->pairs);
    events_free(&s->events);
    events_free(&s->more);
    contacts_free(&s->contacts);
    sleepers_free(&s->sleepers);
    free(s->stopped_in_round);
}
//<

//> Let nodes stay
// A rigid body stays as a whole, of a soft one only the node. Says how
// many nodes had moved until then.
static uint32_t stay(struct simulation *s, uint32_t node,
                     uint32_t round)
{
    struct scene *scene = &s->scene;
    const struct body *body = &scene->body[scene->body_of_node[node]];
    if (s->stopped_in_round[node])
        return 0;
    const bool rigid = body->motion == RIGID;
    const uint32_t begin = rigid ? body->begin.node : node;
    const uint32_t end = rigid ? body->end.node : node + 1;
    for (uint32_t i = begin; i < end; i++) {
        s->stopped_in_round[i] = round;
        for (int k = 0; k < 3; k++)
            scene->predicted[k][i] = scene->mesh.x[k][i];
    }
    return end - begin;
}
//<

//> Begin the rounds
// Round 1 is for what cannot move at all.
static void begin_rounds(struct simulation *s)
{
    const struct scene *scene = &s->scene;
    for (uint32_t i = 0; i < scene->mesh.nodes; i++) {
        const uint32_t b = scene->body_of_node[i];
        s->stopped_in_round[i] = is_held(&scene->body[b]);
    }
}
//<

//> Stop in rounds
static void stop_in_rounds(struct simulation *s,
                           struct step_report *report)
{
    const struct events *events = &s->events;
    struct event_search search = {.scene = &s->scene,
                                  .pairs = &s->pairs,
                                  .tolerance = s->tolerance,
                                  .stopped_in_round =
                                      s->stopped_in_round,
                                  .round = 2,
                                  .threads = s->threads};
    for (;;) {
        uint32_t fresh = 0;
        for (uint64_t e = 0; e < events->all.count; e++)
            for (int k = 0; k < 4; k++)
                fresh +=
                    stay(s, events->all.event[e].node[k], search.round);
        report->stopped += fresh;
        report->rounds++;
        if (fresh == 0)
            break;
        find_events(&s->more, &search);
        contacts_merge(&s->contacts, &s->scene, &s->more);
        events = &s->more;
        search.round++;
    }
}
//<

//> Damp what stays
// It has not moved, whatever its velocity said: it keeps only so much
// of that, or it would gather speed while it is held.
static const double DAMPING = 0.8;

static void damp(struct body *body)
{
    for (int k = 0; k < 3; k++) {
        body->velocity[k] *= DAMPING;
        body->angular_velocity[k] *= DAMPING;
    }
}
//<

//> Go where nothing is in the way
static void advance(struct simulation *s)
{
    struct scene *scene = &s->scene;
    for (uint32_t b = 0; b < scene->bodies; b++) {
        struct body *body = &scene->body[b];
        if (body->motion != RIGID)
            continue;
        if (s->stopped_in_round[body->begin.node]) {
            damp(body);
            continue;
        }
        const struct pose pose = pose_after(body, s->dt);
        memcpy(body->position, pose.position, sizeof pose.position);
        memcpy(body->orientation, pose.orientation,
               sizeof pose.orientation);
    }
    for (int k = 0; k < 3; k++)
        memcpy(scene->mesh.x[k], scene->predicted[k],
               scene->mesh.nodes * sizeof(double));
}
//<

//> Handle the events
static void handle(struct simulation *s, struct step_report *report)
{
    if (!s->passive) {
        contacts_age(&s->contacts, &s->scene);
        contacts_merge(&s->contacts, &s->scene, &s->events);
        stop_in_rounds(s, report);
    }
    advance(s);
    if (!s->passive)
        sleep_or_wake(&s->sleepers, &s->scene, &s->contacts);
}
//<

//> Narrow down the pairs
static void search_boxes(struct simulation *s)
{
    const struct broad_search search = {&s->boxes, s->scene.group,
                                        &s->pairs, s->threads};
    find_pairs(s->broad_phase, s->kept, &search);
}

static void search_pairs(struct simulation *s)
{
    const struct event_search search = {.scene = &s->scene,
                                        .pairs = &s->pairs,
                                        .tolerance = s->tolerance,
                                        .stopped_in_round =
                                            s->stopped_in_round,
                                        .round = 1,
                                        .threads = s->threads};
    begin_rounds(s);
    find_events(&s->events, &search);
}

static void predict(struct simulation *s)
{
    scene_accelerate(&s->scene, s->dt);
    solve_contacts(&s->contacts, &s->scene);
    scene_predict(&s->scene, s->dt, s->threads);
}
//<

//> Take a step
struct step_report take_step(struct simulation *s)
{
    struct step_report report = {0};
    int64_t begin[PHASES + 1] = {clock_ns()};
    predict(s);
    begin[CAPTURE] = clock_ns();
    capture(&s->boxes, &s->scene, s->tolerance, s->threads);
    begin[BROAD] = clock_ns();
    search_boxes(s);
    begin[NARROW] = clock_ns();
    search_pairs(s);
    begin[HANDLE] = clock_ns();
    handle(s, &report);
    begin[PHASES] = clock_ns();
    for (int phase = 0; phase < PHASES; phase++)
        report.ns[phase] = begin[phase + 1] - begin[phase];
    report.tested = s->pairs.tested;
    report.candidates = s->pairs.count;
    report.paired = s->events.all.pairs;
    report.apart = s->events.all.apart;
    report.hits = s->events.all.hits;
    report.events = s->events.all.count;
    report.tests = s->events.all.counts;
    report.contacts = s->contacts.count;
    report.asleep = s->sleepers.asleep;
    return report;
}
//<

//> Count what crosses
void search_now(struct simulation *s)
{
    for (int k = 0; k < 3; k++)
        memcpy(s->scene.predicted[k], s->scene.mesh.x[k],
               s->scene.mesh.nodes * sizeof(double));
    capture(&s->boxes, &s->scene, s->tolerance, s->threads);
    search_boxes(s);
}

uint64_t count_crossing(struct simulation *s)
{
    search_now(s);
    return count_meeting(&s->scene, &s->pairs, s->threads);
}
//<
//<
