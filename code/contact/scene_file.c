// Words from left to right: the shape with its numbers, then words that
// say more, with theirs.
#include "contact/scene_file.h"
#include "ch13-contact/read_mesh.h"
#include "ch13-contact/shapes.h"
#include "common/fail.h"
#include "common/fields.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct reader {
    struct lines lines;
    const char *field; // the next one of the line; NULL: none
    struct scene scene;
};

// Beyond that, squares of coordinates say nothing any more.
static const double MAX_NUMBER = 1e9;

static double take_number(struct reader *reader, double min, double max,
                          const char *expected)
{
    double number;
    if (!reader->field || !read_number(reader->field, ' ', &number) ||
        !(number >= min && number <= max))
        reject(&reader->lines, expected);
    reader->field = next_field(reader->field, ' ');
    return number;
}

static uint32_t take_count(struct reader *reader, double min,
                           double max, const char *expected)
{
    const uint32_t count =
        take_whole(&reader->lines, reader->field, min, max, expected);
    reader->field = next_field(reader->field, ' ');
    return count;
}

static void take_vector(struct reader *reader, double x[3],
                        const char *expected)
{
    for (int k = 0; k < 3; k++)
        x[k] = take_number(reader, -MAX_NUMBER, MAX_NUMBER, expected);
}

static bool is_next(struct reader *reader, const char *word)
{
    if (!reader->field || !begins_with(reader->field, word))
        return false;
    reader->field = next_field(reader->field, ' ');
    return true;
}

static void take_file(struct reader *reader)
{
    if (!reader->field)
        reject(&reader->lines, "file and the name of a mesh");
    const char *scene = reader->lines.stream->name;
    const char *slash = strrchr(scene, '/');
    const char *end = field_end(reader->field, ' ');
    const int length = (int)(end - reader->field);
    const int folder =
        slash && *reader->field != '/' ? (int)(slash + 1 - scene) : 0;
    char *name = allocate((size_t)folder + length + 1, 1);
    snprintf(name, (size_t)folder + length + 1, "%.*s%.*s", folder,
             scene, length, reader->field);
    read_mesh(name, &reader->scene.mesh);
    free(name);
    reader->field = next_field(reader->field, ' ');
}

static void take_torus(struct reader *reader)
{
    static const char expected[] = "torus, the radius of the tube, and "
                                   "two numbers of sides from 3 "
                                   "to 10000";
    const double tube = take_number(reader, 1e-6, 1e6, expected);
    const uint32_t around = take_count(reader, 3, 10000, expected);
    const uint32_t across = take_count(reader, 3, 10000, expected);
    add_torus(&reader->scene.mesh, tube, around, across);
}

static void take_shape(struct reader *reader)
{
    struct mesh *mesh = &reader->scene.mesh;
    if (is_next(reader, "sphere"))
        add_sphere(mesh, take_count(reader, 0, 8,
                                    "sphere and its cuts, 0 to 8"));
    else if (is_next(reader, "torus"))
        take_torus(reader);
    else if (is_next(reader, "box"))
        add_box(mesh, take_count(reader, 1, 1000,
                                 "box and its cuts, 1 to 1000"));
    else if (is_next(reader, "cloth"))
        add_square_sheet(mesh,
                         take_count(reader, 1, 1000,
                                    "cloth and its cuts, 1 to 1000"));
    else if (is_next(reader, "file"))
        take_file(reader);
    else
        reject(&reader->lines,
               "sphere, torus, box, cloth, file or gravity");
}

static void take_initial_state(struct reader *reader,
                               struct initial_state *initial)
{
    if (is_next(reader, "at"))
        take_vector(reader, initial->position, "at and three numbers");
    else if (is_next(reader, "size"))
        initial->size = take_number(reader, 1e-9, MAX_NUMBER,
                                    "size and a number above 0");
    else if (is_next(reader, "velocity"))
        take_vector(reader, initial->velocity,
                    "velocity and three numbers");
    else if (is_next(reader, "spin"))
        take_vector(reader, initial->angular_velocity,
                    "spin and three numbers");
    else if (is_next(reader, "fixed"))
        initial->motion = FIXED;
    else if (is_next(reader, "soft"))
        initial->motion = SOFT;
    else
        reject(&reader->lines,
               "at, size, velocity, spin, fixed or soft");
}

static void take_line_of_scene(struct reader *reader)
{
    reader->field = reader->lines.line;
    if (is_next(reader, "gravity")) {
        take_vector(reader, reader->scene.gravity,
                    "gravity and three numbers");
        if (reader->field)
            reject(&reader->lines, "gravity and three numbers");
        return;
    }
    const struct mesh_mark since = mesh_mark(&reader->scene.mesh);
    struct initial_state initial = {RIGID};
    take_shape(reader);
    while (reader->field)
        take_initial_state(reader, &initial);
    scene_add(&reader->scene, since, &initial);
}

struct scene read_scene(const char *name)
{
    struct stream stream = stream_open(name);
    stream_reserve(&stream, 2 * (size_t)LONGEST_LINE);
    struct reader reader = {.lines = lines_of(&stream)};
    while (next_line(&reader.lines))
        take_line_of_scene(&reader);
    if (reader.scene.bodies == 0)
        fail("%s: expected bodies, found none", stream.name);
    lines_free(&reader.lines);
    stream_close(&stream);
    scene_complete(&reader.scene);
    return reader.scene;
}
