//> Read STL
// Triangles one by one, each with its normal, which we do not need: the
// order of the corners says it, too. Where triangles meet, each has its
// own copy of the corners; they become one node.
#include "ch13-contact/read_mesh.h"
#include "common/fail.h"
#include "common/fields.h"
#include <inttypes.h>
#include <math.h>
#include <string.h>

//> Read STL as text
// facet normal and three numbers; outer loop; three times vertex and
// three numbers; endloop; endfacet. Words may be capitals.
static bool is_line(const struct lines *lines, const char *word)
{
    const size_t length = strlen(word);
    const char *line = lines->line;
    for (size_t k = 0; k < length; k++)
        if ((line[k] | ' ') != word[k])
            return false;
    return line[length] == ' ' || line[length] == 0;
}

static void need_word(struct lines *lines, const char *word)
{
    need_line(lines, word);
    if (!is_line(lines, word))
        reject(lines, word);
}
//<

//> Take a facet
static void take_facet(struct lines *lines, struct mesh *mesh)
{
    const uint32_t first = mesh->nodes;
    need_word(lines, "outer");
    for (int k = 0; k < 3; k++) {
        need_word(lines, "vertex");
        take_node(lines, behind_word(lines->line), mesh,
                  "vertex and three finite coordinates");
    }
    need_word(lines, "endloop");
    need_word(lines, "endfacet");
    mesh_add_triangle(mesh, first, first + 1, first + 2);
}
//<

//> Take all facets
void read_stl_text(struct lines *lines, struct mesh *mesh)
{
    const struct mesh_mark since = mesh_mark(mesh);
    while (next_line(lines)) {
        if (is_line(lines, "facet"))
            take_facet(lines, mesh);
        else if (!is_line(lines, "solid") &&
                 !is_line(lines, "endsolid"))
            reject(lines, "solid, facet or endsolid");
    }
    mesh_merge(mesh, since);
}
//<

//> Read binary STL
// 80 bytes of anything, the number of triangles, and for each the
// normal, three corners and two bytes of anything: numbers of 32 bits,
// the lowest byte first.
static float take_float(const unsigned char *b)
{
    const uint32_t bits = low_byte_first(b);
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}
//<

//> Take three corners from bytes
enum { STL_NORMAL = 12 };

static void take_stl_triangle(const struct stream *stream, size_t at,
                              uint64_t t, struct mesh *mesh)
{
    const unsigned char *b =
        (const unsigned char *)stream->bytes + at + STL_NORMAL;
    uint32_t c[3];
    for (int k = 0; k < 3; k++, b += 12) {
        const double x = take_float(b);
        const double y = take_float(b + 4), z = take_float(b + 8);
        if (!isfinite(x) || !isfinite(y) || !isfinite(z))
            fail("%s: triangle %" PRIu64 ": expected finite "
                 "coordinates",
                 stream->name, t);
        c[k] = mesh_add_node(mesh, x, y, z);
    }
    mesh_add_triangle(mesh, c[0], c[1], c[2]);
}
//<

//> Take triangles from a stream
void read_stl_binary(struct stream *stream, struct mesh *mesh)
{
    const struct mesh_mark since = mesh_mark(mesh);
    const uint64_t count =
        (stream_size(stream) - STL_HEAD) / STL_TRIANGLE;
    size_t at = STL_HEAD;
    for (uint64_t t = 0; t < count; t++, at += STL_TRIANGLE) {
        if (stream->length - at < STL_TRIANGLE) {
            stream_drop(stream, at);
            at = 0;
        }
        while (stream->length < STL_TRIANGLE)
            if (stream_more(stream) == 0)
                fail("%s: triangle %" PRIu64 ": expected 50 bytes, "
                     "found the end of the file",
                     stream->name, t);
        take_stl_triangle(stream, at, t, mesh);
    }
    mesh_merge(mesh, since);
}
//<
//<
