//> Declare the shapes
// Bodies to try things on, added to the end of a mesh, their middle at
// the origin, all but the square sheet closed. Corners are
// counterclockwise seen from outside.
#pragma once
#include "ch13-contact/mesh.h"

// A sphere of radius 1: an icosahedron, each triangle of which is cut
// in four so many times. 20 4^cuts triangles; at most 10 cuts.
void add_sphere(struct mesh *mesh, int cuts);

// A torus: its tube has this radius, its middle line 1. 2 around across
// triangles, both at least 3.
void add_torus(struct mesh *mesh, double tube, uint32_t around,
               uint32_t across);

// A cube of side 2, each face a lattice of cuts by cuts squares: 12
// cuts^2 triangles.
void add_box(struct mesh *mesh, uint32_t cuts);

// A square sheet of side 2 in the plane z = 0, of cuts by cuts squares:
// 2 cuts^2 triangles.
void add_square_sheet(struct mesh *mesh, uint32_t cuts);
//<
