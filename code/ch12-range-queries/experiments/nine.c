// Nine points in the plane and one box, the example of the chapter:
// what each structure looks at, with leaves and cells so small that
// there are some.
//
//     nine
#include "ch12-range-queries/cell_array.h"
#include "ch12-range-queries/kd_tree.h"
#include "ch12-range-queries/orthotree.h"
#include "ch12-range-queries/projection.h"
#include "common/experiment.h"
#include <inttypes.h>

enum { N = 9 };
static const double xs[N] = {5, 8, 1.5, 6, 3, 0, 4.5, 2.5, 7};
static const double ys[N] = {3.5, 8, 3.8, 1, 2.5, 0, 7, 3, 4.5};
static const struct range box = {{2, 2}, {6, 4}};

static uint32_t found[N];

static void print_report(const char *name, struct report report)
{
    row("%s\t%" PRIu64 "\t%" PRIu64 "\t%u", name, report.steps,
        report.tested, report.count);
}

static void print_projection(const struct point_set *points)
{
    struct projection projection = projection_make(points);
    struct report report = {found};
    projection_query(&projection, &box, &report);
    print_report("nine_projection", report);
    projection_free(&projection);
}

static void print_kd_tree(const struct point_set *points)
{
    struct kd_tree tree = kd_make(points, 3, 1);
    struct report report = {found};
    kd_query(&tree, &box, &report);
    print_report("nine_kd_tree", report);
    kd_free(&tree);
}

static void print_orthotree(const char *name,
                            const struct point_set *points,
                            bool compressed)
{
    struct orthotree tree = ortho_make(points, 2, compressed);
    struct report report = {found};
    ortho_query(&tree, &box, &report);
    print_report(name, report);
    ortho_free(&tree);
}

static void print_cells(const char *name,
                        const struct point_set *points, bool in_order)
{
    struct cell_array cells = cell_array_make(points, 0.56, in_order);
    struct report report = {found};
    cell_array_query(&cells, &box, &report);
    print_report(name, report);
    cell_array_free(&cells);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    print_header(&e, "name steps tested found");
    struct point_set points = point_set_allocate(N, 2);
    memcpy(points.x[0], xs, sizeof xs);
    memcpy(points.x[1], ys, sizeof ys);
    print_projection(&points);
    print_kd_tree(&points);
    print_orthotree("nine_orthotree", &points, false);
    print_orthotree("nine_compressed", &points, true);
    print_cells("nine_cells", &points, false);
    print_cells("nine_cells_halves", &points, true);
    point_set_free(&points);
}
