// How many pages the system has to find and clear for one sort by
// cells: chapter 4's, the partition in memory of its own, and the
// partition in a workspace that has served one sort before. With pages
// as small as they come, and with large ones where there are any; one
// thread.
//     faults [POINTS]
#include "ch05-collisions/partition.h"
#include "common/experiment.h"
#include <sys/prctl.h>
#include <sys/resource.h>

static long faults(void)
{
    struct rusage usage;
    if (getrusage(RUSAGE_SELF, &usage) != 0)
        fail("the system does not count page faults");
    return usage.ru_minflt;
}

static void use_large_pages(bool large)
{
    if (prctl(PR_SET_THP_DISABLE, !large, 0, 0, 0) != 0)
        fail("the system does not say no to large pages");
}

enum way { SERIAL, FRESH, KEPT };

static void sort_once(const struct grid *grid, struct points points,
                      enum way way, struct workspace *workspace)
{
    if (way == SERIAL) {
        struct cells cells = cells_sort(grid, points);
        struct points sorted = points_in_order(points, cells.point, 1);
        points_free(&sorted);
        cells_free(&cells);
        return;
    }
    struct mark mark = workspace_mark(workspace);
    partition_points(grid, points, 1, NO_RESTORE, workspace);
    workspace_release(workspace, mark);
}

static long faults_of(const struct grid *grid, struct points points,
                      enum way way, bool large)
{
    struct workspace workspace = {0};
    use_large_pages(large);
    if (way == KEPT)
        sort_once(grid, points, way, &workspace);
    long before = faults();
    sort_once(grid, points, way, &workspace);
    long after = faults();
    workspace_free(&workspace);
    return after - before;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000000, 2, MANY);
    struct question question = kind_question("uniform", n, 1);
    struct grid grid = grid_fit(&question, 2);
    static const char *const names[] = {"serial", "partition",
                                        "partition_kept"};
    print_header(&e, "name n small large");
    for (enum way way = SERIAL; way <= KEPT; way++) {
        long small = faults_of(&grid, question.points, way, false);
        long large = faults_of(&grid, question.points, way, true);
        row("%s\t%u\t%ld\t%ld", names[way], n, small, large);
    }
}
