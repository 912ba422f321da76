//> Read OFF
// The word OFF; how many nodes, faces and edges (which nobody needs);
// each node's coordinates; each face's number of corners, and these,
// from 0. What follows on a face's line is its color.
#include "ch13-contact/read_mesh.h"
#include "common/fields.h"
#include "common/points.h"

//> Read the head of OFF
struct off_head {
    uint32_t nodes, faces;
};

static struct off_head read_head(struct lines *lines)
{
    static const char expected[] = "numbers of nodes, faces and edges";
    need_line(lines, "the word OFF");
    if (!begins_with(lines->line, "OFF"))
        reject(lines, "the word OFF");
    const char *field = behind_word(lines->line);
    if (!field) {
        need_line(lines, expected);
        field = lines->line;
    }
    const uint32_t nodes =
        take_whole(lines, field, 0, NO_INDEX - 1, expected);
    const uint32_t faces = take_whole(lines, next_field(field, ' '), 0,
                                      NO_INDEX - 1, expected);
    return (struct off_head){nodes, faces};
}
//<

//> Cut a face of OFF into triangles
static void take_off_face(const struct lines *lines, uint32_t first,
                          struct mesh *mesh)
{
    static const char expected[] =
        "a number of corners, 3 or more, and as many nodes";
    const double last = (double)mesh->nodes - first - 1;
    const char *field = lines->line;
    const uint32_t corners =
        take_whole(lines, field, 3, NO_INDEX - 1, expected);
    uint32_t c[3] = {0};
    for (uint32_t k = 0; k < corners; k++) {
        field = next_field(field, ' ');
        take_corner(mesh, c, k,
                    first +
                        take_whole(lines, field, 0, last, expected));
    }
}
//<

void read_off(struct lines *lines, struct mesh *mesh)
{
    const uint32_t first = mesh->nodes;
    const struct off_head head = read_head(lines);
    for (uint32_t i = 0; i < head.nodes; i++) {
        need_line(lines, "three finite coordinates of a node");
        take_node(lines, lines->line, mesh,
                  "three finite coordinates of a node");
    }
    for (uint32_t f = 0; f < head.faces; f++) {
        need_line(lines, "the corners of a face");
        take_off_face(lines, first, mesh);
    }
    if (next_line(lines))
        reject(lines, "nothing behind the last face");
}
//<
