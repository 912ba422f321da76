//> Declare the mesh
// Nodes and triangles of all bodies of a scene, one body after the
// other, in one set of arrays.
#pragma once
#include <stdint.h>

//> Hold a mesh
// The corners of a triangle are node numbers, counterclockwise if seen
// from outside. There may be room for more.
struct mesh {
    uint32_t nodes, triangles;
    double *x[3];          // x[k][i]: coordinate k of node i
    uint32_t (*corner)[3]; // corner[t]: the nodes of triangle t
    uint32_t node_room, triangle_room;
};
//<

// {0} is an empty one; released with mesh_free. Each adds to the end
// and says the number of what it added. Fails beyond 2^32 - 2.
uint32_t mesh_add_node(struct mesh *mesh, double x, double y, double z);
uint32_t mesh_add_triangle(struct mesh *mesh, uint32_t a, uint32_t b,
                           uint32_t c);
void mesh_free(struct mesh *mesh);

// Where a mesh ends now: what is added later begins there.
struct mesh_mark {
    uint32_t node, triangle;
};
struct mesh_mark mesh_mark(const struct mesh *mesh);

// Makes one node of all that have the same coordinates, to the last
// bit but that -0 is 0, among those added since. Of equal ones the
// first stays. Triangles that have lost a corner by that are removed.
void mesh_merge(struct mesh *mesh, struct mesh_mark since);
//<
