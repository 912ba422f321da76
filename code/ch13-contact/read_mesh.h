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
// The next line; fails at the end of the file: expected this.
void need_line(struct lines *lines, const char *expected);

// The whole number from min to max in this field, NULL if there is
// none; or the line is rejected.
uint32_t take_whole(const struct lines *lines, const char *field,
                    double min, double max, const char *expected);

// Three finite numbers from this field on, and a node with them; or the
// line is rejected: expected this.
void take_node(const struct lines *lines, const char *field,
               struct mesh *mesh, const char *expected);

// Takes corner k of a face, its corners one by one from 0: from the
// third on, each makes a triangle, which is added. c[] is kept between.
void take_corner(struct mesh *mesh, uint32_t c[3], uint32_t k,
                 uint32_t node);

// Whether the line begins with this word, and what follows it: NULL if
// there is nothing.
bool begins_with(const char *line, const char *word);
const char *behind_word(const char *line);

// Bytes of a binary STL file: what comes before the triangles, and what
// each of these has. Its numbers have the lowest byte first.
enum { STL_HEAD = 84, STL_TRIANGLE = 50 };
uint32_t low_byte_first(const unsigned char *bytes);
//<
