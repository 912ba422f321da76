// A pile over its steps: bodies fall, touch, come to rest and sleep.
// Counts of some steps, the energy of motion, the height of the middle
// of all, and how many pairs of triangles cross, none: seen to after
// each tenth step, and added up since the row before.
//
//     pile [BODIES [STEPS [ROWS]]]
#include "ch13-contact/experiments/setting.h"

struct state {
    double bodies, energy, height; // of those that are not fixed
};

// Of a body on average, in units of its mass.
static struct state state_of(const struct scene *scene)
{
    struct state state = {0};
    for (uint32_t b = 0; b < scene->bodies; b++) {
        const struct body *body = &scene->body[b];
        if (body->motion == FIXED)
            continue;
        state.bodies++;
        state.height += body->position[2];
        for (int k = 0; k < 3; k++)
            state.energy += 0.5 * body->velocity[k] * body->velocity[k];
    }
    state.energy /= state.bodies;
    state.height /= state.bodies;
    return state;
}

static void print_row(const struct simulation *s, uint32_t step,
                      const struct step_report *report,
                      uint64_t crossing)
{
    const struct state state = state_of(&s->scene);
    row("pile_%u\t%u\t%.0f\t%u\t%.0f\t%.0f\t%.0f\t%.0f\t%.0f\t%u\t%.4g"
        "\t%u\t%u\t%.5g\t%.5g\t%.0f",
        step, step, state.bodies, s->scene.mesh.triangles,
        (double)report->tested, (double)report->candidates,
        (double)report->paired,
        (double)(report->paired - report->apart),
        (double)report->events, report->contacts,
        (double)report->stopped / s->scene.mesh.nodes, report->rounds,
        report->asleep, state.energy, state.height, (double)crossing);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t bodies = parameter(&e, "BODIES", 60, 1, 100000);
    const uint32_t steps = parameter(&e, "STEPS", 300, 1, MANY);
    const uint32_t rows = parameter(&e, "ROWS", 30, 1, MANY);
    const struct built_in *pile = find_built_in("pile");
    struct simulation s =
        simulation_of(build_scene(pile, bodies, 1),
                      find_broad_phase("clusters"), pile->dt,
                      2); // counts, no times
    const uint32_t gap = (steps + rows - 1) / rows;
    uint64_t crossing = 0;
    print_header(
        &e,
        "name step bodies triangles tested candidates paired narrow "
        "events contacts stopped rounds asleep energy height "
        "crossing");
    for (uint32_t step = 1; step <= steps; step++) {
        const struct step_report report = take_step(&s);
        if (step % 10 == 0)
            crossing += count_crossing(&s);
        if (step % gap != 0)
            continue;
        print_row(&s, step, &report, crossing);
        crossing = 0;
    }
    simulation_free(&s);
}
