//> Build scenes
// Bodies begin on a lattice wide enough for them to turn in.
#include "ch13-contact/scenes.h"
#include "ch13-contact/shapes.h"
#include "common/random.h"
#include <math.h>
#include <string.h>

//> Draw a number between two
static double between(struct random *random, double low, double high)
{
    return low + (high - low) * random_uniform(random);
}

static void draw_vector(struct random *random, double max, double x[3])
{
    for (int k = 0; k < 3; k++)
        x[k] = between(random, -max, max);
}
//<

//> Add a body of a random shape
// A sphere, a torus or a box, none of them reaching further than size
// from its middle.
static void add_random(struct scene *scene, struct random *random,
                       struct initial_state *initial, double size)
{
    const struct mesh_mark since = mesh_mark(&scene->mesh);
    switch (random_bits(random) % 3) {
    case 0:
        add_sphere(&scene->mesh, 1);
        initial->size = size;
        break;
    case 1:
        add_torus(&scene->mesh, 0.4, 8, 5);
        initial->size = size / 1.4;
        break;
    default:
        add_box(&scene->mesh, 2);
        initial->size = size / sqrt(3);
    }
    scene_add(scene, since, initial);
}
//<

//> Fill a cloud
void fill_cloud(struct scene *scene, uint32_t n, double speed,
                uint64_t seed)
{
    enum { SPACING = 2 };
    struct random random = {seed};
    const uint32_t side = (uint32_t)ceil(cbrt(n));
    for (uint32_t b = 0; b < n; b++) {
        struct initial_state initial = {
            RIGID, .position = {SPACING * (b % side),
                                SPACING * (b / side % side),
                                SPACING * (double)(b / side / side)}};
        draw_vector(&random, speed / sqrt(3), initial.velocity);
        draw_vector(&random, speed / sqrt(3), initial.angular_velocity);
        add_random(scene, &random, &initial, 0.95);
    }
}

static void fill_usual_cloud(struct scene *scene, uint32_t size,
                             uint64_t seed)
{
    fill_cloud(scene, size, 1, seed);
}
//<

//> Stand walls around a floor
// Sheets of two triangles: a floor at height 0 and four walls, from
// -half to half.
static void add_walls(struct scene *scene, double half, double height)
{
    for (int wall = 0; wall < 5; wall++) {
        const struct mesh_mark since = mesh_mark(&scene->mesh);
        struct mesh *mesh = &scene->mesh;
        add_square_sheet(mesh, 1);
        for (uint32_t i = since.node; i < mesh->nodes; i++) {
            const double u = half * mesh->x[0][i];
            const double v = mesh->x[1][i];
            const double across = wall % 2 ? half : -half;
            mesh->x[0][i] = wall == 0 || wall > 2 ? u : across;
            mesh->x[1][i] = wall == 0   ? half * v
                            : wall <= 2 ? u
                                        : across;
            mesh->x[2][i] = wall == 0 ? 0 : height * (v + 1) / 2;
        }
        scene_add(scene, since, &(struct initial_state){FIXED});
    }
}
//<

//> Fill a pile
static void fill_pile(struct scene *scene, uint32_t size, uint64_t seed)
{
    struct random random = {seed};
    const uint32_t side = (uint32_t)ceil(cbrt(size / 2.0));
    const double spacing = 2.2, half = spacing * side / 2 + 0.2;
    add_walls(scene, half, spacing * (size / side / side + 2));
    for (uint32_t b = 0; b < size; b++) {
        const uint32_t at[3] = {b % side, b / side % side,
                                b / side / side};
        struct initial_state initial = {RIGID};
        draw_vector(&random, 0.1, initial.position);
        for (int k = 0; k < 3; k++)
            initial.position[k] += spacing * (at[k] + 0.5);
        for (int k = 0; k < 2; k++)
            initial.position[k] += 0.2 - half;
        initial.position[2] += 0.5;
        draw_vector(&random, 1, initial.velocity);
        draw_vector(&random, 2, initial.angular_velocity);
        add_random(scene, &random, &initial,
                   between(&random, 0.5, 0.95));
    }
    scene->gravity[2] = -10;
}
//<

//> Shoot a bullet at a sheet
// In one step it goes ten times through its own length: neither at the
// beginning nor at the end of a step is anything to be seen.
static void fill_bullet(struct scene *scene, uint32_t size,
                        uint64_t seed)
{
    (void)seed;
    struct mesh_mark since = mesh_mark(&scene->mesh);
    add_square_sheet(&scene->mesh, size);
    scene_add(scene, since, &(struct initial_state){FIXED, 2});
    since = mesh_mark(&scene->mesh);
    add_sphere(&scene->mesh, 1);
    scene_add(scene, since,
              &(struct initial_state){RIGID, 0.05,
                                      .position = {0.1, 0.2, 3.5},
                                      .velocity = {0, 0, -100}});
}
//<

//> Fold a cloth
// The right half is thrown over the left; waves on both, in different
// directions, make them meet.
static void fill_cloth(struct scene *scene, uint32_t size,
                       uint64_t seed)
{
    (void)seed;
    const struct mesh_mark since = mesh_mark(&scene->mesh);
    add_square_sheet(&scene->mesh, size);
    scene_add(scene, since, &(struct initial_state){SOFT, 4});
    scene_complete(scene);
    const struct mesh *mesh = &scene->mesh;
    for (uint32_t i = 0; i < mesh->nodes; i++) {
        const double x = mesh->x[0][i], y = mesh->x[1][i];
        scene->velocity[0][i] = x > 0 ? -2 * x : 0;
        scene->velocity[2][i] =
            x > 0 ? 0.2 * x + 0.5 * sin(2 * x) * cos(3 * y)
                  : -0.5 * sin(3 * x);
    }
}
//<

//> Link two rings
// The second passes through the first, and moves until they touch.
static void fill_rings(struct scene *scene, uint32_t size,
                       uint64_t seed)
{
    (void)seed;
    for (int ring = 0; ring < 2; ring++) {
        const struct mesh_mark since = mesh_mark(&scene->mesh);
        struct initial_state initial = {RIGID,
                                        .position = {1.1 * ring, 0, 0}};
        add_torus(&scene->mesh, 0.3, 2 * size, size);
        if (ring == 1) { // stand it up
            for (uint32_t i = since.node; i < scene->mesh.nodes; i++) {
                const double y = scene->mesh.x[1][i];
                scene->mesh.x[1][i] = -scene->mesh.x[2][i];
                scene->mesh.x[2][i] = y;
            }
            initial.velocity[0] = 1;
            initial.angular_velocity[2] = 0.5;
        }
        scene_add(scene, since, &initial);
    }
}
//<

//> Set a giant among dwarfs
// A few large triangles and many small ones, what cells of one width
// cannot serve.
static void fill_giant(struct scene *scene, uint32_t size,
                       uint64_t seed)
{
    struct mesh_mark since = mesh_mark(&scene->mesh);
    add_sphere(&scene->mesh, 0);
    const double side = ceil(cbrt(size));
    scene_add(scene, since,
              &(struct initial_state){
                  FIXED, 2 * side,
                  .position = {-2 * side - 1.2, side, side}});
    fill_cloud(scene, size, 1, seed);
}
//<

//> Fill the table of scenes
const struct built_in built_ins[] = {
    {"pile", "bodies of three shapes fall into a box", 1000, 1, 1000000,
     0.01, fill_pile},
    {"cloud", "bodies in random motion, close together", 200, 1,
     10000000, 0.05, fill_usual_cloud},
    {"giant", "the same beside a body of 20 large triangles", 200, 1,
     1000000, 0.05, fill_giant},
    {"bullet", "a bullet at a sheet of so many squares a side", 10, 1,
     10000, 0.01, fill_bullet},
    {"cloth", "a sheet that folds, so many squares a side", 40, 1,
     10000, 0.02, fill_cloth},
    {"rings", "two linked rings, so many sides each", 12, 3, 10000,
     0.02, fill_rings},
};
const int built_in_count = sizeof built_ins / sizeof *built_ins;
//<

const struct built_in *find_built_in(const char *name)
{
    for (int row = 0; row < built_in_count; row++)
        if (strcmp(built_ins[row].name, name) == 0)
            return &built_ins[row];
    return NULL;
}

//> Build a scene of the table
struct scene build_scene(const struct built_in *built_in, uint32_t size,
                         uint64_t seed)
{
    struct scene scene = {0};
    built_in->fill(&scene, size, seed);
    if (!scene.predicted[0]) // a fill that sets velocities has done it
        scene_complete(&scene);
    return scene;
}
//<
//<
