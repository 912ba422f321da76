//> Generate shapes
// Sphere and box are made triangle by triangle, with three nodes each,
// and then equal nodes are merged. That works because the same place is
// computed in the same way from either side, to the last bit.
#include "ch13-contact/shapes.h"
#include <assert.h>
#include <math.h>

//> Cut a triangle in four
struct vertex {
    double x[3];
};

// The middle of two places, moved out to the sphere. A sum is the same
// whichever of the two is first.
static struct vertex middle_of(const struct vertex *a,
                               const struct vertex *b)
{
    struct vertex m;
    double length2 = 0;
    for (int k = 0; k < 3; k++) {
        m.x[k] = a->x[k] + b->x[k];
        length2 += m.x[k] * m.x[k];
    }
    for (int k = 0; k < 3; k++)
        m.x[k] /= sqrt(length2);
    return m;
}
//<

//> Cut until it is fine
static void add_cut(struct mesh *mesh, const struct vertex p[3],
                    int cuts)
{
    if (cuts == 0) {
        uint32_t c[3];
        for (int k = 0; k < 3; k++)
            c[k] = mesh_add_node(mesh, p[k].x[0], p[k].x[1], p[k].x[2]);
        mesh_add_triangle(mesh, c[0], c[1], c[2]);
        return;
    }
    const struct vertex m[3] = {middle_of(&p[0], &p[1]),
                                middle_of(&p[1], &p[2]),
                                middle_of(&p[2], &p[0])};
    add_cut(mesh, (struct vertex[]){p[0], m[0], m[2]}, cuts - 1);
    add_cut(mesh, (struct vertex[]){m[0], p[1], m[1]}, cuts - 1);
    add_cut(mesh, (struct vertex[]){m[2], m[1], p[2]}, cuts - 1);
    add_cut(mesh, m, cuts - 1);
}
//<

//> Begin with an icosahedron
// Its corners are those of three rectangles of sides 1 and the golden
// ratio, one in each plane of two axes.
static const double golden = 1.6180339887498949;

static struct vertex corner_of_icosahedron(int c)
{
    const int k = c / 4; // the axis on which the place is 0
    const double length = sqrt(1 + golden * golden);
    struct vertex p = {{0}};
    p.x[(k + 1) % 3] = (c & 1 ? -1 : 1) / length;
    p.x[(k + 2) % 3] = (c & 2 ? -golden : golden) / length;
    return p;
}

void add_sphere(struct mesh *mesh, int cuts)
{
    static const uint8_t corner[20][3] = {
        {0, 1, 4},   {0, 6, 1},  {0, 4, 8},   {0, 9, 6},  {0, 8, 9},
        {1, 10, 4},  {1, 6, 11}, {1, 11, 10}, {2, 5, 3},  {2, 3, 7},
        {2, 8, 5},   {2, 7, 9},  {2, 9, 8},   {3, 5, 10}, {3, 11, 7},
        {3, 10, 11}, {4, 5, 8},  {4, 10, 5},  {6, 9, 7},  {6, 7, 11}};
    const struct mesh_mark since = mesh_mark(mesh);
    for (int t = 0; t < 20; t++) {
        struct vertex p[3];
        for (int k = 0; k < 3; k++)
            p[k] = corner_of_icosahedron(corner[t][k]);
        add_cut(mesh, p, cuts);
    }
    mesh_merge(mesh, since);
}
//<

//> Add a lattice of squares
// Node (i, j) of a lattice that has so many columns is first + i *
// columns + j, taken around at the ends. Each square is two triangles.
struct lattice {
    uint32_t first, rows, columns;
};

static uint32_t node_at(struct lattice l, uint32_t i, uint32_t j)
{
    return l.first + i % l.rows * l.columns + j % l.columns;
}

static void add_square(struct mesh *mesh, struct lattice l, uint32_t i,
                       uint32_t j)
{
    const uint32_t a = node_at(l, i, j), b = node_at(l, i + 1, j);
    const uint32_t c = node_at(l, i + 1, j + 1);
    mesh_add_triangle(mesh, a, b, c);
    mesh_add_triangle(mesh, a, c, node_at(l, i, j + 1));
}
//<

//> Bend a lattice to a torus
void add_torus(struct mesh *mesh, double tube, uint32_t around,
               uint32_t across)
{
    assert(around >= 3 && across >= 3 && "a tube has an inside");
    const double turn = 2 * acos(-1);
    const struct lattice l = {mesh->nodes, around, across};
    for (uint32_t i = 0; i < around; i++)
        for (uint32_t j = 0; j < across; j++) {
            const double u = turn * i / around, v = turn * j / across;
            const double r = 1 + tube * cos(v);
            mesh_add_node(mesh, r * cos(u), r * sin(u), tube * sin(v));
        }
    for (uint32_t i = 0; i < around; i++)
        for (uint32_t j = 0; j < across; j++)
            add_square(mesh, l, i, j);
}
//<

//> Lay out a sheet
// In the plane that coordinate axis crosses at the height; turned over
// if that is negative, so that outside is away from the origin.
static void add_sheet(struct mesh *mesh, uint32_t cuts, int axis,
                      double height)
{
    const struct lattice l = {mesh->nodes, cuts + 1, cuts + 1};
    for (uint32_t i = 0; i <= cuts; i++)
        for (uint32_t j = 0; j <= cuts; j++) {
            const double u = 2.0 * i / cuts - 1, v = 2.0 * j / cuts - 1;
            double x[3];
            x[axis] = height;
            x[(axis + 1) % 3] = height < 0 ? v : u;
            x[(axis + 2) % 3] = height < 0 ? u : v;
            mesh_add_node(mesh, x[0], x[1], x[2]);
        }
    for (uint32_t i = 0; i < cuts; i++)
        for (uint32_t j = 0; j < cuts; j++)
            add_square(mesh, l, i, j);
}

void add_square_sheet(struct mesh *mesh, uint32_t cuts)
{
    add_sheet(mesh, cuts, 2, 0);
}

void add_box(struct mesh *mesh, uint32_t cuts)
{
    const struct mesh_mark since = mesh_mark(mesh);
    for (int axis = 0; axis < 3; axis++) {
        add_sheet(mesh, cuts, axis, 1);
        add_sheet(mesh, cuts, axis, -1);
    }
    mesh_merge(mesh, since);
}
//<
//<
