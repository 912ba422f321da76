// Shapes, and meshes from files, good and hostile.
#include "ch13-contact/read_mesh.h"
#include "ch13-contact/shapes.h"
#include "common/allocate.h"
#include "common/random.h"
#include "harness.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// ---- shapes --------------------------------------------------------
// Six times the volume that the triangles enclose.
static double volume6(const struct mesh *m)
{
    double sum = 0;
    for (uint32_t t = 0; t < m->triangles; t++) {
        double p[3][3];
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++)
                p[c][k] = m->x[k][m->corner[t][c]];
        for (int k = 0; k < 3; k++)
            sum += p[0][k] * (p[1][(k + 1) % 3] * p[2][(k + 2) % 3] -
                              p[1][(k + 2) % 3] * p[2][(k + 1) % 3]);
    }
    return sum;
}

static bool has_edge(const struct mesh *m, uint32_t a, uint32_t b)
{
    uint32_t count = 0;
    for (uint32_t t = 0; t < m->triangles; t++)
        for (int c = 0; c < 3; c++)
            count +=
                m->corner[t][c] == a && m->corner[t][(c + 1) % 3] == b;
    return count == 1;
}

// Each edge once in either direction: closed, and all triangles are
// turned the same way. Nodes and triangles of a ball, or with a hole.
static void check_closed(struct mesh *m, int holes, const char *name)
{
    bool closed = true;
    for (uint32_t t = 0; t < m->triangles; t++)
        for (int c = 0; c < 3; c++)
            closed &=
                has_edge(m, m->corner[t][(c + 1) % 3], m->corner[t][c]);
    CHECK(closed, "%s", name);
    CHECK_INT(m->triangles / 2 + 2 - 2 * holes, m->nodes, "nodes of %s",
              name);
    CHECK(volume6(m) > 0, "%s has its outside outside", name);
    mesh_free(m);
}

static void shapes_are_closed(void)
{
    struct mesh m = {0};
    for (int cuts = 0; cuts < 3; cuts++) {
        add_sphere(&m, cuts);
        CHECK_INT(20 << 2 * cuts, m.triangles, "sphere");
        check_closed(&m, 0, "sphere");
    }
    add_torus(&m, 0.3, 9, 4);
    CHECK_INT(72, m.triangles, "torus");
    check_closed(&m, 1, "torus");
    for (uint32_t cuts = 1; cuts < 4; cuts++) {
        add_box(&m, cuts);
        CHECK_INT(12 * cuts * cuts, m.triangles, "box");
        check_closed(&m, 0, "box");
    }
    add_box(&m, 3);
    CHECK_NEAR(48, volume6(&m), 1e-9, "six times the volume of a box");
    add_square_sheet(&m, 5);
    CHECK_INT(108 + 50, m.triangles, "box and cloth");
    CHECK_INT(56 + 36, m.nodes, "box and cloth");
    mesh_free(&m);
}

static void equal_nodes_are_merged(void)
{
    struct mesh m = {0};
    mesh_add_node(&m, 0, 0, 0);
    const struct mesh_mark since = mesh_mark(&m);
    for (uint32_t k = 0; k < 2; k++) {
        const uint32_t a = mesh_add_node(&m, k ? -0.0 : 0.0, 0, 0);
        mesh_add_node(&m, 1, 0, 0);
        mesh_add_node(&m, 1, k + 1, 0);
        mesh_add_triangle(&m, a, a + 1, a + 2);
    }
    mesh_add_triangle(&m, 1, 4, 2); // its corners are two places
    mesh_merge(&m, since);
    CHECK_INT(5, m.nodes, "one was there before");
    CHECK_INT(2, m.triangles, "one had two equal corners");
    CHECK_INT(1, m.corner[1][0], "the zeros are equal");
    CHECK_INT(4, m.corner[1][2], "moved up");
    mesh_free(&m);
}

// ---- files ---------------------------------------------------------
static char path[64];

static void name_file(const char *ending)
{
    static int count;
    snprintf(path, sizeof path, "/tmp/mesh-%d-%d%s", (int)getpid(),
             count++, ending);
}

static void write_file(const char *ending, const void *bytes,
                       size_t length)
{
    name_file(ending);
    FILE *file = fopen(path, "wb");
    if (file) {
        fwrite(bytes, 1, length, file);
        fclose(file);
    }
}

static void read_into(void *mesh)
{
    read_mesh(path, mesh);
}

static const char off[] = "OFF\n# a tetrahedron\n4 3 0\n0 0 0\n1 0 0\n"
                          "0 1 0\n0 0 1\n3 0 2 1 255 0 0\n"
                          "3 0 1 3\n4 1 2 3 0\n";
static const char obj[] =
    "o thing\nv 0 0 0\nv 1 0 0 1\nv 0 1 0\nvn 0 0 1\nv 0 0 1\n"
    "f 1/1/1 3//1 2\nf -4 -3 -1\nf 2 3 4 1\ns off\n";
static const char stl[] =
    "solid s\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n"
    "  vertex 0 1 0\n  vertex 1 0 0\n endloop\nendfacet\n"
    "FACET normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
    "vertex 0 0 1e0\nendloop\nendfacet\nendsolid s\n";

static size_t binary_stl(unsigned char bytes[184])
{
    static const float corner[2][9] = {{0, 0, 0, 0, 1, 0, 1, 0, 0},
                                       {0, 0, 0, 1, 0, 0, 0, 0, 1}};
    memset(bytes, 0, 184);
    memcpy(bytes, "solid is a word that says nothing", 33);
    bytes[80] = 2;
    for (int t = 0; t < 2; t++)
        memcpy(bytes + 84 + 50 * t + 12, corner[t], 36);
    return 184;
}

static void check_mesh(uint32_t nodes, uint32_t triangles,
                       const char *what)
{
    struct mesh m = {0};
    mesh_add_node(&m, 5, 5, 5); // what is there stays
    read_mesh(path, &m);
    unlink(path);
    CHECK_INT(nodes + 1, m.nodes, "nodes of %s", what);
    CHECK_INT(triangles, m.triangles, "triangles of %s", what);
    CHECK_INT(1, m.corner[0][0], "the first node of %s", what);
    for (uint32_t t = 0; t < m.triangles; t++)
        for (int c = 0; c < 3; c++)
            CHECK(m.corner[t][c] >= 1 && m.corner[t][c] < m.nodes,
                  "%s: triangle %u", what, t);
    mesh_free(&m);
}

static void meshes_are_read(void)
{
    unsigned char bytes[184];
    write_file(".off", off, sizeof off - 1);
    check_mesh(4, 4, "OFF");
    write_file(".OBJ", obj, sizeof obj - 1);
    check_mesh(4, 4, "OBJ");
    write_file(".stl", stl, sizeof stl - 1);
    check_mesh(4, 2, "STL, text");
    write_file(".stl", bytes, binary_stl(bytes));
    check_mesh(4, 2, "STL, binary");
}

static void bad_meshes_are_refused(void)
{
    static const struct {
        const char *ending, *text, *sentence;
    } bad[] = {
        {".ply", "ply", "whose name ends in .off, .obj or .stl"},
        {".off", "", ":1: expected the word OFF, found the end"},
        {".off", "NOFF\n", ":1: expected the word OFF"},
        {".off", "OFF\n1\n", ":2: expected numbers of nodes"},
        {".off", "OFF 1 1 0\n0 0\n", ":2: expected three finite coord"},
        {".off", "OFF 1 1 0\n0 0 nan\n",
         ":2: expected three finite coordinates of a node, found"},
        {".off", "OFF 1 1 0\n-inf 0 0\n", ":2: expected three finite"},
        {".obj", "v 0 0 0\nv 0 NaN 0\n",
         ":2: expected v and three finite coordinates, found"},
        {".obj", "v 1 2 Infinity\n", ":1: expected v and three fin"},
        {".obj", "v 1 2 1e999\n", ":1: expected v and three fin"},
        {".stl", "solid\nfacet\nouter\nvertex 1 nan 2\n",
         ":4: expected vertex and three finite coordinates, found"},
        {".stl", "solid\nfacet\nouter\nvertex inf 0 2\n", ":4: exp"},
        {".off", "OFF 1 1 0\n0 0 1e99\n", ":2: expected coordinates"},
        {".off", "OFF 4e9 1 0\n0 0 1\n", ":3: expected three finite"},
        {".off", "OFF 1 1 0\n0 0 1\n3 0 0 1\n", ":3: expected a num"},
        {".off", "OFF 1 1 0\n0 0 1\n4000000000 0 0\n", ":3: expected"},
        {".off", "OFF 1 1 0\n0 0 1\n2 0 0\n", ":3: expected a number"},
        {".off", "OFF 1 0 0\n0 0 1\n", "expected triangles, found"},
        {".off", "OFF 1 0 0\n0 0 1\n3 0 0 0\n", ":3: expected nothing"},
        {".obj", "v 0 0 0\nf 1 1 2\n", ":2: expected three or more"},
        {".obj", "v 0 0 0\nf 1 1 -2\n", ":2: expected three or more"},
        {".obj", "v 0 0 0\nf 1 1\n", ":2: expected three or more"},
        {".obj", "v 0 0 0\nf 1 1 0\n", ":2: expected three or more"},
        {".obj", "v 0 0 0\nf 1 1 1x\n", ":2: expected three or more"},
        {".obj", "v 0 0\n", ":1: expected v and three finite"},
        {".obj", "# nothing\n", "expected triangles, found none"},
        {".stl", "solid\nfacet\nvertex 1 2 3\n", ":3: expected outer"},
        {".stl", "solid\nfacet\nouter\nvertex 1 2\n", ":4: expected"},
        {".stl", "solid\nfacet\nouter\n", ":4: expected vertex, fo"},
        {".stl", "solid\nbox\n", ":2: expected solid, facet or"},
        {".stl", "\001\002", ":1: expected text, found a binary"},
    };
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        struct mesh m = {0};
        write_file(bad[k].ending, bad[k].text, strlen(bad[k].text));
        CHECK_FAILS(bad[k].sentence, read_into, &m, "\"%s\"",
                    bad[k].text);
        unlink(path);
    }
    unsigned char bytes[184];
    binary_stl(bytes);
    static const float odd[] = {NAN, INFINITY, -INFINITY};
    for (int k = 0; k < 3; k++) {
        struct mesh m = {0};
        memcpy(bytes + 84 + 50 + 12 + 12 * k, &odd[k], 4);
        write_file(".stl", bytes, 184);
        CHECK_FAILS("triangle 1: expected finite coordinates",
                    read_into, &m, "%g", (double)odd[k]);
        unlink(path);
        binary_stl(bytes);
    }
}

// A file with some bytes changed is read, or refused by a sentence; all
// of that in a process of its own, which then says so.
static void read_and_say_so(void *unused)
{
    (void)unused;
    struct mesh m = {0};
    read_mesh(path, &m);
    for (uint32_t t = 0; t < m.triangles; t++)
        for (int c = 0; c < 3; c++)
            if (m.corner[t][c] >= m.nodes)
                abort();
    fprintf(stderr, "contact: expected");
    exit(2);
}

static void hostile_bytes_end_in_a_sentence(void)
{
    static const char *const texts[] = {off, obj, stl};
    static const char *const endings[] = {".off", ".obj", ".stl",
                                          ".stl"};
    struct random random = {77};
    const uint32_t cases = at_most("MOST_CASES", 160);
    for (uint32_t k = 0; k < cases; k++) {
        unsigned char bytes[400];
        const int kind = k % 4;
        size_t length = kind < 3 ? strlen(texts[kind]) : 0;
        if (kind < 3)
            memcpy(bytes, texts[kind], length);
        else
            length = binary_stl(bytes);
        for (int change = 0; change < 3; change++) {
            const size_t at = random_bits(&random) % length;
            const uint64_t draw = random_bits(&random);
            bytes[at] = draw % 2 ? "0123456789 -\n/e."[draw / 2 % 16]
                                 : (unsigned char)(draw / 2);
        }
        if (random_bits(&random) % 4 == 0)
            length = random_bits(&random) % length;
        write_file(endings[kind], bytes, length);
        CHECK_FAILS("expected", read_and_say_so, NULL, "case %u", k);
        unlink(path);
    }
}

int main(void)
{
    return RUN_TESTS("contact", TEST(shapes_are_closed),
                     TEST(equal_nodes_are_merged),
                     TEST(meshes_are_read),
                     TEST(bad_meshes_are_refused),
                     TEST(hostile_bytes_end_in_a_sentence));
}
