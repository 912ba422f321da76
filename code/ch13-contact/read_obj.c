//> Read OBJ
// Lines that begin with v are nodes, lines that begin with f faces,
// whose corners are numbers of nodes, from 1, or if negative counted
// back from the last. Behind a slash are numbers that we do not need;
// nor do we need lines with other words.
#include "ch13-contact/read_mesh.h"
#include "common/fields.h"
#include "common/numbers.h"
#include <math.h>

//> Take a node's number of OBJ
// The node that a field says; the line is rejected if there is none.
static uint32_t take_number(const struct lines *lines,
                            const char *field, uint32_t first,
                            const struct mesh *mesh)
{
    const double nodes = mesh->nodes - first;
    double number = 0;
    const char *end = field ? number_from_text(field, &number) : NULL;
    if (!end || end == field || (*end && *end != ' ' && *end != '/') ||
        number != floor(number) || number == 0 || fabs(number) > nodes)
        reject(lines,
               "three or more numbers of nodes that came before");
    const double place = number > 0 ? number - 1 : nodes + number;
    return first + (uint32_t)place;
}
//<

//> Take a face of OBJ
static void take_face(const struct lines *lines, uint32_t first,
                      struct mesh *mesh)
{
    const char *field = behind_word(lines->line);
    uint32_t c[3] = {0};
    for (uint32_t k = 0; k < 3 || field; k++) {
        take_corner(mesh, c, k, take_number(lines, field, first, mesh));
        field = next_field(field, ' ');
    }
}
//<

void read_obj(struct lines *lines, struct mesh *mesh)
{
    const uint32_t first = mesh->nodes;
    while (next_line(lines)) {
        if (begins_with(lines->line, "v"))
            take_node(lines, behind_word(lines->line), mesh,
                      "v and three finite coordinates");
        else if (begins_with(lines->line, "f"))
            take_face(lines, first, mesh);
    }
}
//<
