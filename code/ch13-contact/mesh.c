//> Hold nodes and triangles
// Adding takes constant time on average. To merge equal nodes takes
// time in proportion to them, by a hash table.
#include "ch13-contact/mesh.h"
#include "ch13-contact/enlarge.h"
#include "common/fail.h"
#include "common/min_max.h"
#include "common/points.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

//> Make room for one more of a mesh
static uint32_t next_room(uint32_t used, const char *what)
{
    if (used >= NO_INDEX - 1)
        fail("more than %u %s", NO_INDEX - 1, what);
    return (uint32_t)MIN(2 * (uint64_t)used + 64, NO_INDEX - 1);
}
//<

//> Add a node to a mesh
uint32_t mesh_add_node(struct mesh *mesh, double x, double y, double z)
{
    const uint32_t i = mesh->nodes;
    if (i == mesh->node_room) {
        mesh->node_room = next_room(i, "nodes");
        for (int k = 0; k < 3; k++)
            mesh->x[k] = enlarge(mesh->x[k], i, mesh->node_room,
                                 sizeof *mesh->x[k]);
    }
    mesh->x[0][i] = x;
    mesh->x[1][i] = y;
    mesh->x[2][i] = z;
    return mesh->nodes++;
}
//<

//> Add a triangle to a mesh
uint32_t mesh_add_triangle(struct mesh *mesh, uint32_t a, uint32_t b,
                           uint32_t c)
{
    const uint32_t t = mesh->triangles;
    if (t == mesh->triangle_room) {
        mesh->triangle_room = next_room(t, "triangles");
        mesh->corner = enlarge(mesh->corner, t, mesh->triangle_room,
                               sizeof *mesh->corner);
    }
    mesh->corner[t][0] = a;
    mesh->corner[t][1] = b;
    mesh->corner[t][2] = c;
    return mesh->triangles++;
}
//<

void mesh_free(struct mesh *mesh)
{
    for (int k = 0; k < 3; k++)
        free(mesh->x[k]);
    free(mesh->corner);
    *mesh = (struct mesh){0};
}

struct mesh_mark mesh_mark(const struct mesh *mesh)
{
    return (struct mesh_mark){mesh->nodes, mesh->triangles};
}

//> Hash three coordinates
// The bits of the numbers, stirred as SplitMix64 stirs its state.
static uint64_t hash_of(const struct mesh *mesh, uint32_t i)
{
    uint64_t hash = 0;
    for (int k = 0; k < 3; k++) {
        const double number = mesh->x[k][i] + 0.0; // -0 becomes 0
        uint64_t bits;
        memcpy(&bits, &number, sizeof bits);
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 29;
    }
    return hash * 0xbf58476d1ce4e5b9;
}

static bool is_same_place(const struct mesh *mesh, uint32_t i,
                          uint32_t j)
{
    return mesh->x[0][i] == mesh->x[0][j] &&
           mesh->x[1][i] == mesh->x[1][j] &&
           mesh->x[2][i] == mesh->x[2][j];
}
//<

//> Find the first node of each place
// A table with twice as many slots as nodes: a node looks from its own
// slot on for one that is empty or holds an equal node. Nodes that stay
// move up; into[] says where each went.
static void merge_nodes(struct mesh *mesh, uint32_t since,
                        uint32_t *into)
{
    int bits = 4;
    while (((uint64_t)1 << bits) < 2 * (uint64_t)(mesh->nodes - since))
        bits++;
    const uint64_t last = ((uint64_t)1 << bits) - 1;
    uint32_t *slot = allocate(last + 1, sizeof *slot);
    memset(slot, 0xff, (last + 1) * sizeof *slot); // NO_INDEX
    uint32_t kept = since;
    for (uint32_t i = since; i < mesh->nodes; i++) {
        uint64_t s = hash_of(mesh, i) >> (64 - bits);
        while (slot[s] != NO_INDEX && !is_same_place(mesh, slot[s], i))
            s = (s + 1) & last;
        if (slot[s] == NO_INDEX) {
            for (int k = 0; k < 3; k++)
                mesh->x[k][kept] = mesh->x[k][i];
            slot[s] = kept++;
        }
        into[i - since] = slot[s];
    }
    mesh->nodes = kept;
    free(slot);
}
//<

//> Give triangles the nodes that stay
void mesh_merge(struct mesh *mesh, struct mesh_mark since)
{
    if (mesh->nodes == since.node)
        return;
    uint32_t *into = allocate(mesh->nodes - since.node, sizeof *into);
    merge_nodes(mesh, since.node, into);
    uint32_t kept = since.triangle;
    for (uint32_t t = since.triangle; t < mesh->triangles; t++) {
        uint32_t c[3];
        for (int k = 0; k < 3; k++)
            c[k] = into[mesh->corner[t][k] - since.node];
        if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0])
            memcpy(mesh->corner[kept++], c, sizeof c);
    }
    mesh->triangles = kept;
    free(into);
}
//<
//<
