// For libFuzzer (`make fuzz`): any bytes are read as a mesh, as OFF,
// OBJ or STL, into an empty mesh and behind the nodes of another. Both
// times the sentence must be the same, or the triangles: their
// coordinates finite, their corners among the nodes.
#include "ch13-contact/read_mesh.h"
#include "fuzz_escape.h"
#include <math.h>
#include <stdbool.h>
#include <sys/mman.h>
#include <unistd.h>

// Links with endings that lead to the bytes, in the folder of the
// build.
enum { PLACE = 100 };
static const char *const names[] = {
    LINKS "/mesh.off", LINKS "/mesh.obj", LINKS "/mesh.stl"};

// Whether it went well; if not, run.sentence says why, and the memory
// of the mesh is gone.
static bool read_behind(const char *name, uint32_t nodes,
                        struct mesh *mesh)
{
    const int descriptor = dup(STDIN_FILENO); // that it will get
    close(descriptor);
    if (setjmp(run.back) == 0) {
        for (uint32_t i = 0; i < nodes; i++)
            mesh_add_node(mesh, i, 0, 0);
        read_mesh(name, mesh);
        return true;
    }
    close(descriptor);
    release_all();
    return false;
}

static void must(bool holds)
{
    if (!holds)
        abort();
}

static void compare(const struct mesh *one, const struct mesh *behind,
                    uint32_t nodes)
{
    must(one->triangles > 0 && one->triangles == behind->triangles);
    must(one->nodes + nodes == behind->nodes);
    for (uint32_t i = 0; i < one->nodes; i++)
        for (int k = 0; k < 3; k++) {
            must(isfinite(one->x[k][i]));
            must(one->x[k][i] == behind->x[k][nodes + i]);
        }
    for (uint32_t t = 0; t < one->triangles; t++)
        for (int k = 0; k < 3; k++) {
            must(one->corner[t][k] < one->nodes);
            must(one->corner[t][k] + nodes == behind->corner[t][k]);
        }
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    enum { NODES = 3 };
    if (size == 0)
        return 0;
    const char *name = names[*data % 3];
    const int file = memfd_create("mesh", 0);
    must(file >= 0 && write(file, data + 1, size - 1) >= 0);
    must(dup2(file, PLACE) == PLACE);
    close(file);
    struct mesh one = {0}, behind = {0};
    char sentence[sizeof run.sentence];
    const bool first = read_behind(name, 0, &one);
    memcpy(sentence, run.sentence, sizeof sentence);
    const bool second = read_behind(name, NODES, &behind);
    must(first == second);
    if (first) {
        compare(&one, &behind, NODES);
        mesh_free(&one);
        mesh_free(&behind);
    } else {
        must(strcmp(sentence, run.sentence) == 0);
    }
    close(PLACE);
    return 0;
}
