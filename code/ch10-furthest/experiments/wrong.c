// How many of the furthest points are wrong that the cells along the
// border and the corner trick find: for points of every kind, and for
// many sets of uniform points, in grids of two points a cell or as the
// coursework's, of sqrt(n).
//
//     wrong [POINTS [SETS]]
#include "algorithms.h"
#include "ch04-cell-sort/sorted.h"
#include "ch10-furthest/border.h"
#include "common/experiment.h"
#include <stdio.h>

static const char *const kinds[] = {"uniform",   "clustered",
                                    "collinear", "circle",
                                    "kuzmin",    "two-clusters"};
enum { KINDS = sizeof kinds / sizeof *kinds };

static double wrong_share(const struct answers *found,
                          const struct answers *right, uint32_t n)
{
    double wrong = 0;
    for (uint32_t i = 0; i < n; i++)
        wrong += found->furthest2[i] != right->furthest2[i];
    return wrong / n;
}

struct wrong {
    double edge, corner;
};

static struct wrong wrong_answers(const struct question *question,
                                  double c)
{
    const uint32_t n = question->points.n;
    struct answers right = answers_for(n, FURTHEST);
    struct answers found = answers_for(n, FURTHEST);
    struct sorted sorted = sorted_make(question, c, cells_sort_alone);
    struct wrong wrong;
    find_algorithm("furthest-hull")->run(question, &right);
    search_edge_cells(question, &sorted, &found);
    wrong.edge = wrong_share(&found, &right, n);
    search_one_corner(question, &sorted, &found);
    wrong.corner = wrong_share(&found, &right, n);
    sorted_free(&sorted);
    answers_free(&found);
    answers_free(&right);
    return wrong;
}

static void print_wrong(const char *name, const char *kind, uint32_t n,
                        double c, int sets)
{
    struct wrong sum = {0, 0};
    int broken = 0;
    for (int set = 0; set < sets; set++) {
        struct question question = kind_question(kind, n, set + 1);
        struct wrong wrong = wrong_answers(&question, c);
        sum.edge += wrong.edge;
        sum.corner += wrong.corner;
        broken += wrong.corner > 0;
        points_free(&question.points);
    }
    row("%s\t%u\t%d\t%.4g\t%.4g\t%.4g\t%.4g", name, n, sets, c,
        sum.edge / sets, sum.corner / sets, (double)broken / sets);
}

int main(int argc, char **argv)
{
    enum { SMALL = 1000 };
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 5000, 100, MANY);
    int sets = parameter(&e, "SETS", 100, 1, MANY);
    columns(&e, "name n sets c edge corner broken");
    for (int k = 0; k < KINDS; k++) {
        char name[40];
        snprintf(name, sizeof name, "wrong_%s", kinds[k]);
        print_wrong(name, kinds[k], n, sqrt(n), 1);
    }
    for (int c = 1; c <= 16; c *= 2) {
        char name[40];
        snprintf(name, sizeof name, "sets_c%d", c);
        print_wrong(name, "uniform", SMALL, c, sets);
    }
    return 0;
}
