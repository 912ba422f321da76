// The broad phases of chapter 13 beside other libraries: which boxes
// meet? Of the triangles of bodies in motion, those of their own body
// included; and of the bodies as wholes. The counts are compared. What
// takes too long to begin with has a scene of fewer boxes, with one of
// ours beside it: the rows that end in _fewer.
//     contacts [BOXES [TRIALS]]
#include "ch13-contact/motion.h"
#include "ch13-contact/scenes.h"
#include "ch13-contact/step.h"
#include "common/experiment.h"
#include "common/min_max.h"
#include "peers/broad_phase_peer.h"
#include <inttypes.h>

enum { MAX_TRIALS = 20, TRIANGLES_PER_BODY = 69, FEWER = 20000 };

static const char *const ours[] = {"clusters", "kd-tree", "cells",
                                   "sweep-kept", "sweep-and-prune"};
static const struct broad_phase_peer *const peers[] = {
    &contact_cgal, &contact_dbvt, &contact_sap};

// Boxes of each step, in both layouts.
struct steps {
    struct boxes boxes[MAX_TRIALS + 1];
    double *row[MAX_TRIALS + 1];
    uint64_t pairs[MAX_TRIALS + 1]; // that meet; 0: not known
};

static void whole_bodies(const struct scene *scene,
                         const struct boxes *triangles,
                         struct boxes *to)
{
    boxes_reserve(to, scene->bodies);
    for (uint32_t b = 0; b < scene->bodies; b++)
        boxes_unite(to, b, triangles, scene->body[b].begin.triangle,
                    scene->body[b].end.triangle);
}

static void lay_out(struct steps *steps, int step)
{
    const struct boxes *boxes = &steps->boxes[step];
    double *row = take(6 * (size_t)boxes->n, sizeof *row);
    for (uint32_t t = 0; t < boxes->n; t++)
        for (int k = 0; k < 3; k++) {
            row[6 * (size_t)t + k] = boxes->low[k][t];
            row[6 * (size_t)t + 3 + k] = boxes->high[k][t];
        }
    steps->row[step] = row;
}

// Bodies pass through each other, in steps of a hundredth of their
// size.
static struct steps *steps_of(uint32_t n, bool whole, int trials)
{
    struct steps *steps = take(1, sizeof *steps);
    struct scene scene = {0};
    fill_cloud(&scene, whole ? n : n / TRIANGLES_PER_BODY + 1, 1, 1);
    scene_complete(&scene);
    for (int step = 0; step <= trials; step++) {
        struct boxes triangles = {0};
        scene_predict(&scene, 1 + 0.01 * step, 1);
        for (int k = 0; k < 3; k++) { // at rest, there
            double *swap = scene.mesh.x[k];
            scene.mesh.x[k] = scene.predicted[k];
            capture(&triangles, &scene, DEFAULT_TOLERANCE, 1);
            scene.mesh.x[k] = swap;
        }
        steps->boxes[step] = triangles;
        if (whole) {
            steps->boxes[step] = (struct boxes){0};
            whole_bodies(&scene, &triangles, &steps->boxes[step]);
            boxes_free(&triangles);
        }
        lay_out(steps, step);
    }
    scene_free(&scene);
    return steps;
}

static void compare(const char *name, struct steps *steps, int step,
                    uint64_t found, bool is_wide)
{
    if (steps->pairs[step] == 0)
        steps->pairs[step] = found;
    if (found < steps->pairs[step] ||
        (found > steps->pairs[step] && !is_wide))
        fail("%s: %" PRIu64 " pairs, and not %" PRIu64, name, found,
             steps->pairs[step]);
}

// The first step, which builds; then the mean of the others, since some
// programs do much in one step and little in the next; and their
// quartiles.
static void print_program(const char *name, const char *kind,
                          const struct steps *steps, const double *ns,
                          int trials, uint64_t found)
{
    double sorted[MAX_TRIALS], sum = 0;
    const double n = steps->boxes[0].n;
    memcpy(sorted, ns + 1, trials * sizeof *ns);
    for (int step = 1; step <= trials; step++)
        sum += ns[step];
    const struct summary summary = summarize(sorted, trials);
    row_begin("%s_%s\t%s\t%s\t%.0f\t%.5g\t%.4g\t%.4g", name, kind, name,
              kind, n, (double)found / n, ns[0] / n, sum / trials / n);
    row_times(&summary, n);
    row_end();
}

static void run_ours(const char *name, const char *kind,
                     struct steps *steps, int trials)
{
    const struct broad_phase *phase = find_broad_phase(name);
    struct pairs pairs = {0};
    double ns[MAX_TRIALS + 1];
    void *kept = phase->begin(phase);
    for (int step = 0; step <= trials; step++) {
        const int64_t start = clock_ns();
        const struct broad_search search = {&steps->boxes[step], NULL,
                                            &pairs, 1};
        find_pairs(phase, kept, &search);
        ns[step] = (double)(clock_ns() - start);
        compare(name, steps, step, pairs.count, false);
    }
    print_program(name, kind, steps, ns, trials, pairs.count);
    phase->end(kept);
    pairs_free(&pairs);
}

static void run_peer(const struct broad_phase_peer *peer,
                     const char *kind, struct steps *steps, int trials)
{
    double ns[MAX_TRIALS + 1];
    uint64_t found = 0;
    int64_t start = clock_ns();
    void *kept = peer->begin(steps->row[0], steps->boxes[0].n);
    for (int step = 0; step <= trials; step++) {
        found = peer->find(kept, steps->row[step]);
        ns[step] = (double)(clock_ns() - start);
        compare(peer->name, steps, step, found, peer->is_wide);
        start = clock_ns();
    }
    print_program(peer->name, kind, steps, ns, trials, found);
    peer->end(kept);
}

static void run_all(uint32_t n, bool whole, int trials, bool slow)
{
    const char *kind = slow ? whole ? "bodies_fewer" : "triangles_fewer"
                       : whole ? "bodies"
                               : "triangles";
    struct steps *steps = steps_of(n, whole, trials);
    for (int k = 0; k < COUNT_OF(ours); k++)
        if (!slow || strcmp(ours[k], "sweep-and-prune") == 0)
            run_ours(ours[k], kind, steps, trials);
    for (int k = 0; k < COUNT_OF(peers); k++)
        if (slow == (bool)peers[k]->is_slow)
            run_peer(peers[k], kind, steps, trials);
    for (int step = 0; step <= trials; step++)
        boxes_free(&steps->boxes[step]);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "BOXES", 10000, 100, 10000000);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    print_header(&e, "name program kind n pairs first mean ns:3");
    for (int whole = 0; whole < 2; whole++) {
        const uint32_t boxes = whole ? n / 4 : n; // made of many each
        run_all(boxes, whole, trials, false);
        run_all(MIN(boxes, FEWER), whole, trials, true);
    }
}
