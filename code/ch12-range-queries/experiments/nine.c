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

static void print_report(const char *name, const struct report *report)
{
    row("%s\t%" PRIu64 "\t%" PRIu64 "\t%u", name, report->steps,
        report->tested, report->count);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    columns(&e, "name steps tested found");
    struct point_set points = point_set_allocate(N, 2);
    memcpy(points.x[0], xs, sizeof xs);
    memcpy(points.x[1], ys, sizeof ys);
    const struct projection projection = projection_make(&points);
    const struct kd_tree kd = kd_make(&points, 3, 1);
    const struct orthotree plain = ortho_make(&points, 2, false);
    const struct orthotree compressed = ortho_make(&points, 2, true);
    const struct cell_array cells =
        cell_array_make(&points, 0.56, false);
    const struct cell_array halves =
        cell_array_make(&points, 0.56, true);
    uint32_t found[6][N];
    struct report report[6];
    for (int k = 0; k < COUNT_OF(report); k++)
        report[k] = (struct report){found[k]};
    projection_query(&projection, &box, &report[0]);
    kd_query(&kd, &box, &report[1]);
    ortho_query(&plain, &box, &report[2]);
    ortho_query(&compressed, &box, &report[3]);
    cell_array_query(&cells, &box, &report[4]);
    cell_array_query(&halves, &box, &report[5]);
    print_report("nine_projection", &report[0]);
    print_report("nine_kd_tree", &report[1]);
    print_report("nine_orthotree", &report[2]);
    print_report("nine_compressed", &report[3]);
    print_report("nine_cells", &report[4]);
    print_report("nine_cells_halves", &report[5]);
}
