// The program contact: gets a scene, takes steps, and writes a table of
// them, their events, their pictures, or a summary.
#include "ch13-contact/static_test.h"
#include "common/fail.h"
#include "contact/help.h"
#include "contact/options.h"
#include "contact/pictures.h"
#include "contact/scene_file.h"
#include "contact/table.h"
#include "near/progress.h"
#include "near/threads.h"
#include "near/write.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct simulation set_up(const struct options *o)
{
    const struct scene scene =
        o->file ? read_scene(o->file)
                : build_scene(o->built_in, o->size, o->seed);
    const double usual = o->built_in ? o->built_in->dt : 0.01;
    struct simulation s =
        simulation_of(scene, o->broad, o->dt > 0 ? o->dt : usual,
                      threads_for(o->threads, scene.mesh.triangles));
    if (o->tolerance > 0)
        s.tolerance = o->tolerance;
    s.passive = o->passive;
    return s;
}

// What crosses at the beginning cannot be kept apart.
static void insist_on_apart(struct simulation *s,
                            const struct options *o)
{
    search_now(s);
    const uint64_t first = first_meeting(&s->scene, &s->pairs);
    if (first == s->pairs.count)
        return;
    const struct pair pair = s->pairs.pair[first];
    fail("%s: bodies %" PRIu32 " and %" PRIu32
         ", numbered from 0, touch at the beginning; --passive takes "
         "them as they are",
         o->file ? o->file : o->built_in->name,
         s->scene.body_of[pair.one], s->scene.body_of[pair.other]);
}

// Whether the candidates are those of all pairs.
static bool pairs_are_right(const struct simulation *s)
{
    struct pairs plain = {0};
    const struct broad_phase *all = find_broad_phase("all-pairs");
    const struct broad_search search = {&s->boxes, s->scene.group,
                                        &plain, s->threads};
    find_pairs(all, NULL, &search);
    const bool right = plain.count == s->pairs.count &&
                       (plain.count == 0 ||
                        memcmp(plain.pair, s->pairs.pair,
                               plain.count * sizeof *plain.pair) == 0);
    pairs_free(&plain);
    return right;
}

static bool step_is_right(struct simulation *s, uint32_t step)
{
    if (!pairs_are_right(s)) {
        fprintf(stderr,
                "check: step %" PRIu32 ": %s has other candidates than "
                "all pairs\n",
                step, s->broad_phase->name);
        return false;
    }
    const uint64_t crossing = s->passive ? 0 : count_crossing(s);
    if (crossing > 0)
        fprintf(stderr,
                "check: step %" PRIu32 ": %" PRIu64
                " pairs of triangles cross\n",
                step, crossing);
    return crossing == 0;
}

static void add_up(struct step_report *sum,
                   const struct step_report *report)
{
    sum->tested += report->tested;
    sum->candidates += report->candidates;
    sum->hits += report->hits;
    sum->events += report->events;
    for (int phase = 0; phase < PHASES; phase++)
        sum->ns[phase] += report->ns[phase];
}

static void print_summary(const struct simulation *s, uint32_t steps,
                          const struct step_report *sum)
{
    static const char *const phases[] = {"predict", "capture", "broad",
                                         "narrow", "handle"};
    const double n = steps, candidates = (double)sum->candidates;
    printf("scene       %" PRIu32 " bodies, %" PRIu32
           " triangles, %" PRIu32 " nodes\n",
           s->scene.bodies, s->scene.mesh.triangles,
           s->scene.mesh.nodes);
    printf("steps       %" PRIu32 " of %g, %s, at most %d thread%s\n",
           steps, s->dt, s->broad_phase->name, s->threads,
           s->threads > 1 ? "s" : "");
    printf("candidates  %.6g a step, %.6g looked at\n", candidates / n,
           (double)sum->tested / n);
    printf("events      %.6g a step; %.3g %% of the candidates have "
           "none\n",
           (double)sum->events / n,
           candidates > 0
               ? 100 * (candidates - (double)sum->hits) / candidates
               : 0);
    for (int phase = 0; phase < PHASES; phase++)
        printf("%-11s %.3g ms a step\n", phases[phase],
               1e-6 * (double)sum->ns[phase] / n);
}

// Says how many steps were not right.
static uint32_t take_steps(struct simulation *s,
                           const struct options *o)
{
    struct step_report sum = {0};
    uint32_t wrong = 0;
    progress_start("steps", o->steps);
    for (uint32_t step = 1; step <= o->steps; step++) {
        const struct step_report report = take_step(s);
        add_up(&sum, &report);
        if (o->output && o->events)
            write_events(step, &s->events);
        else if (o->output)
            write_step(step, &report);
        if (o->pictures)
            pictures_add(o->pictures, s, step, o->steps);
        if (o->check)
            wrong += !step_is_right(s, step);
        progress_rows(1);
    }
    progress_stop();
    if (!o->output)
        print_summary(s, o->steps, &sum);
    if (o->check && wrong == 0)
        fprintf(o->output ? stderr : stdout,
                "check: all %" PRIu32 " steps are right\n", o->steps);
    return wrong;
}

static int contact(const struct options *o)
{
    struct simulation s = set_up(o);
    if (!o->passive)
        insist_on_apart(&s, o);
    if (o->pictures)
        pictures_begin(o->pictures, &s.scene, o->steps);
    if (o->output) {
        write_open(o->output);
        if (o->events)
            write_event_head();
        else
            write_step_head();
    }
    const uint32_t wrong = take_steps(&s, o);
    if (o->output && wrong == 0)
        write_close();
    else
        write_abandon(); // what is wrong is not worth a file
    simulation_free(&s);
    return wrong == 0 ? 0 : 1;
}

int main(int argc, char **argv)
{
    fail_as("contact");
    insist_on_output();
    reexec_with_passive_wait(argv);
    const struct options options = parse_contact_options(argc, argv);
    int status = 0;
    if (options.help)
        print_contact_help();
    else if (options.list)
        print_contact_list();
    else
        status = contact(&options);
    return status;
}
