//> Read a mesh from a file
// The ending of its name says what it is. Only an STL file has to be
// looked into: a binary one has just as many bytes as its number of
// triangles says, and may begin with the word that a text begins with.
#include "ch13-contact/read_mesh.h"
#include "ch13-contact/exact.h"
#include "common/fail.h"
#include "common/fields.h"
#include <math.h>
#include <string.h>
#include <strings.h>

//> Take a number or a node from a line
void need_line(struct lines *lines, const char *expected)
{
    if (!next_line(lines))
        fail("%s:%zu: expected %s, found the end of the file",
             lines->stream->name, lines->number + 1, expected);
}

uint32_t take_whole(const struct lines *lines, const char *field,
                    double min, double max, const char *expected)
{
    double number;
    if (!field || !read_number(field, ' ', &number) ||
        !(number >= min && number <= max && number == floor(number)))
        reject(lines, expected);
    return (uint32_t)number;
}

void take_node(const struct lines *lines, const char *field,
               struct mesh *mesh, const char *expected)
{
    double x[3];
    for (int k = 0; k < 3; k++) {
        if (!field || !read_number(field, ' ', &x[k]) ||
            !isfinite(x[k]))
            reject(lines, expected);
        field = next_field(field, ' ');
    }
    if (!within_exact_bounds(x, 3))
        reject(lines, "coordinates that are 0 or not beyond 2^-280 and "
                      "2^280");
    mesh_add_node(mesh, x[0], x[1], x[2]);
}

void take_corner(struct mesh *mesh, uint32_t c[3], uint32_t k,
                 uint32_t node)
{
    c[k < 3 ? k : 2] = node;
    if (k >= 2) {
        mesh_add_triangle(mesh, c[0], c[1], c[2]);
        c[1] = c[2];
    }
}

bool begins_with(const char *line, const char *word)
{
    const size_t length = strlen(word);
    return strncmp(line, word, length) == 0 &&
           (line[length] == ' ' || line[length] == 0);
}

const char *behind_word(const char *line)
{
    return next_field(line, ' ');
}
//<

//> Tell a binary STL file
uint32_t low_byte_first(const unsigned char *bytes)
{
    return bytes[0] | bytes[1] << 8 | bytes[2] << 16 |
           (uint32_t)bytes[3] << 24;
}

static bool is_binary_stl(const struct stream *stream)
{
    if (stream->length < STL_HEAD)
        return false;
    const uint64_t count =
        low_byte_first((unsigned char *)stream->bytes + STL_HEAD - 4);
    return stream_size(stream) == STL_HEAD + STL_TRIANGLE * count;
}

static void read_stl(struct lines *lines, struct mesh *mesh)
{
    struct stream *stream = lines->stream;
    while (stream->length < STL_HEAD && stream_more(stream) > 0)
        ;
    if (is_binary_stl(stream)) {
        read_stl_binary(stream, mesh);
    } else {
        *lines = (struct lines){.stream = stream,
                                .next = stream->bytes,
                                .end = stream->bytes,
                                .copy = lines->copy};
        read_stl_text(lines, mesh);
    }
}
//<

//> Choose the reader
typedef void reader(struct lines *lines, struct mesh *mesh);

static reader *reader_of(const char *name)
{
    static const struct {
        const char *ending;
        reader *read;
    } kinds[] = {
        {".off", read_off}, {".obj", read_obj}, {".stl", read_stl}};
    const size_t length = strlen(name);
    for (int k = 0; k < 3; k++)
        if (length > 4 &&
            strcasecmp(name + length - 4, kinds[k].ending) == 0)
            return kinds[k].read;
    fail("%s: expected a file whose name ends in .off, .obj or .stl",
         name);
}

void read_mesh(const char *name, struct mesh *mesh)
{
    reader *read = reader_of(name);
    const struct mesh_mark since = mesh_mark(mesh);
    struct stream stream = stream_open(name);
    stream_reserve(&stream, 2 * (size_t)LONGEST_LINE);
    struct lines lines = lines_of(&stream);
    read(&lines, mesh);
    if (mesh->triangles == since.triangle)
        fail("%s: expected triangles, found none", name);
    lines_free(&lines);
    stream_close(&stream);
}
//<
//<
