// Cells with points and distances for a point, in both geometries, of
// uniform points: expected where only one corner matters, or with
// wraparound far from any seam, and counted.
//     visits [MOST [SETS]]
#include "ch10-furthest/experiments/expected_far.h"
#include "ch10-furthest/furthest_branch_and_bound.h"
#include "ch10-furthest/furthest_cells.h"
#include "common/experiment.h"

static void search_alone(const struct question *question,
                         const struct partition *partition,
                         struct workspace *workspace)
{
    const struct sorted *sorted = &partition->sorted;
    const struct rows rows = rows_find(sorted, workspace);
    const struct far_scene scene = {sorted, &rows, question->space};
    struct neighbor found;
    for (uint32_t s = 0; s < sorted->points.n; s++)
        furthest_of_one(&scene, s, &found, question->counts);
}

// Of so many sets of points, added up.
static struct counts count_visits(enum geometry geometry, bool batched,
                                  uint32_t n, int sets)
{
    struct counts sum = {0};
    struct workspace workspace = {0};
    const struct mark empty = workspace_mark(&workspace);
    for (int set = 0; set < sets; set++) {
        struct question question =
            uniform_question(geometry, n, set + 1);
        struct partition partition = partition_make(
            &question, POINTS_PER_FAR_CELL, RESTORE, &workspace);
        question.counts = &sum;
        if (batched)
            search_furthest_cells(&question, &partition, &workspace,
                                  new_answers(n, FURTHEST));
        else
            search_alone(&question, &partition, &workspace);
        workspace_release(&workspace, empty);
        forget();
    }
    workspace_free(&workspace);
    return sum;
}

// A cell without points is not visited. With wraparound the own cell is
// never empty, and a point there is compared with itself.
static void print_visits(enum geometry geometry, uint32_t n, int sets)
{
    const double c = POINTS_PER_FAR_CELL, all = (double)n * sets;
    const double own = geometry == WRAPAROUND ? 1 : 0;
    const double cells = expected_outside(geometry, c);
    struct counts alone = count_visits(geometry, false, n, sets);
    struct counts together = count_visits(geometry, true, n, sets);
    row("%s_visits_%u\t%u\t%d\t%.4g\t%.4g\t%.4g\t%.4g\t%.4g\t%.4g"
        "\t%.4g",
        own > 0 ? "wraparound" : "standard", n, n, sets, c,
        own + (cells - own) * (1 - exp(-c)), alone.cells / all,
        own + cells * c, alone.distances / all, together.cells / all,
        together.distances / all);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 10000, 1000, MANY / 10);
    int sets = parameter(&e, "SETS", 10, 1, MANY);
    print_header(
        &e, "name n sets c cells_expected cells distances_expected "
            "distances cells_together distances_together");
    for (uint32_t n = 1000; n <= most; n *= 10)
        print_visits(STANDARD, n, sets);
    for (uint32_t n = 1000; n <= most; n *= 10)
        print_visits(WRAPAROUND, n, sets);
}
