// A file for each picture has its triangles, those that have an event
// apart from the others; the script says how to draw them.
#include "contact/pictures.h"
#include "common/allocate.h"
#include "common/fail.h"
#include "common/min_max.h"
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static FILE *open_in(const char *folder, const char *name)
{
    char path[4096];
    if (snprintf(path, sizeof path, "%s/%s", folder, name) >=
        (int)sizeof path)
        fail("--pictures: the name is too long");
    FILE *file = fopen(path, "w");
    if (!file)
        fail("cannot write %s: %s", path, strerror(errno));
    return file;
}

static void close_file(FILE *file, const char *folder)
{
    const bool bad = ferror(file);
    if (fclose(file) != 0 || bad)
        fail("cannot write in %s: %s", folder, strerror(errno));
}

static uint32_t between_pictures(uint32_t steps)
{
    return (steps + MAX_PICTURES - 1) / MAX_PICTURES;
}

static void write_ranges(FILE *script, const struct scene *scene)
{
    double middle[3], reach = 0;
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (uint32_t i = 0; i < scene->mesh.nodes; i++) {
            low = MIN(low, scene->mesh.x[k][i]);
            high = MAX(high, scene->mesh.x[k][i]);
        }
        middle[k] = low / 2 + high / 2;
        reach = MAX(reach, high / 2 - low / 2);
    }
    for (int k = 0; k < 3; k++)
        fprintf(script, "set %crange [%.9g:%.9g]\n", 'x' + k,
                middle[k] - 1.1 * reach, middle[k] + 1.1 * reach);
}

void pictures_begin(const char *folder, const struct scene *scene,
                    uint32_t steps)
{
    if (mkdir(folder, 0777) != 0 && errno != EEXIST)
        fail("cannot make %s: %s", folder, strerror(errno));
    FILE *script = open_in(folder, "pictures.gp");
    const uint32_t gap = between_pictures(steps);
    fprintf(script, "# Run it in this folder: gnuplot pictures.gp\n"
                    "set terminal pngcairo size 900,900\n"
                    "set view 70,30\nset view equal xyz\n"
                    "unset border\nunset tics\nunset key\n"
                    "set pm3d depthorder border linecolor 'black' "
                    "linewidth 0.3\nset style fill solid 1\n");
    write_ranges(script, scene);
    for (uint32_t step = 1; step <= steps; step++)
        if ((steps - step) % gap == 0)
            fprintf(script,
                    "set output 'step-%06" PRIu32 ".png'\n"
                    "splot 'step-%06" PRIu32 ".dat' index 0 with "
                    "polygons fillcolor 'gray80', '' index 1 with "
                    "polygons fillcolor 'gray40'\n",
                    step, step);
    close_file(script, folder);
}

static void write_triangle(FILE *file, const struct mesh *mesh,
                           uint32_t t)
{
    for (int c = 0; c < 4; c++) {
        const uint32_t i = mesh->corner[t][c % 3];
        fprintf(file, "%.6g %.6g %.6g\n", mesh->x[0][i], mesh->x[1][i],
                mesh->x[2][i]);
    }
    fprintf(file, "\n");
}

// A triangle stands apart that has a node of an event. The first of the
// others is no part of a body: an index is never empty.
void pictures_add(const char *folder, const struct simulation *s,
                  uint32_t step, uint32_t steps)
{
    if ((steps - step) % between_pictures(steps) != 0)
        return;
    const struct mesh *mesh = &s->scene.mesh;
    const struct event_list *events = &s->events.all;
    uint8_t *has_event = allocate(mesh->nodes, 1);
    memset(has_event, 0, mesh->nodes);
    for (uint64_t e = 0; e < events->count; e++)
        for (int k = 0; k < 4; k++)
            has_event[events->event[e].node[k]] = 1;
    char name[32];
    snprintf(name, sizeof name, "step-%06" PRIu32 ".dat", step);
    FILE *file = open_in(folder, name);
    for (int index = 0; index < 2; index++) {
        for (uint32_t t = 0; t < mesh->triangles; t++) {
            const uint32_t *c = mesh->corner[t];
            const bool apart =
                has_event[c[0]] | has_event[c[1]] | has_event[c[2]];
            const bool fixed =
                s->scene.body[s->scene.body_of[t]].motion == FIXED;
            if (apart == (index == 1) && !(fixed && mesh->nodes > 500))
                write_triangle(file, mesh, t);
        }
        const double x = mesh->x[0][0], y = mesh->x[1][0];
        const double z = mesh->x[2][0];
        fprintf(file, "%.6g %.6g %.6g\n%.6g %.6g %.6g\n\n\n", x, y, z,
                x, y, z);
    }
    close_file(file, folder);
    free(has_event);
}
