//> Declare the reader of meshes
// Triangles from a file: OFF (Geomview), OBJ (Wavefront), or STL as
// text or binary; which one, its name's ending says. Faces of more than
// three corners are cut into triangles from their first corner. A '#'
// begins a comment in a text.
#pragma once
#include "ch13-contact/mesh.h"
#include "common/lines.h"

// Adds what the file has, at least one triangle, to the end of the
// mesh; all coordinates are finite. STL knows no nodes: corners at the
// same place, exactly, become one. Fails with the name of the file, the
// line, and what was found there.
void read_mesh(const char *name, struct mesh *mesh);

// One kind each. Of a text, no line is taken yet.
void read_off(struct lines *lines, struct mesh *mesh);
void read_obj(struct lines *lines, struct mesh *mesh);
void read_stl_text(struct lines *lines, struct mesh *mesh);
void read_stl_binary(struct stream *stream, struct mesh *mesh);

// ---- what they share -----------------------------------------------
// Three finite numbers from this field on, and a node with them; or the
// line is rejected: expected this.
void take_node(const struct lines *lines, const char *field,
               struct mesh *mesh, const char *expected);

// Whether the line begins with this word, and what follows it: NULL if
// there is nothing.
bool begins_with(const char *line, const char *word);
const char *behind_word(const char *line);
//<
