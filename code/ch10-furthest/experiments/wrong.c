// How many of the furthest points are wrong that the cells along the
// border and the corner trick find: for points of every kind, and for
// many sets of uniform points, in grids of two points a cell or as the
// coursework's, of sqrt(n).
//     wrong [POINTS [SETS]]
#include "ch04-cell-sort/sorted.h"
#include "ch10-furthest/coursework_furthest.h"
#include "common/experiment.h"

static const char *const kinds[] = {"uniform",   "clustered",
                                    "collinear", "circle",
                                    "kuzmin",    "two-clusters"};

static double wrong_share(const struct answers *found,
                          const struct answers *right, uint32_t n)
{
    double wrong = 0;
    for (uint32_t i = 0; i < n; i++)
        wrong += found->furthest2[i] != right->furthest2[i];
    return wrong / n;
}

// Over sets of points: the mean share of wrong answers of both searches
// and the share of sets in which the corner trick has any.
static void print_wrong(const char *name, const char *kind, uint32_t n,
                        double c, int sets)
{
    double edge = 0, corner = 0, broken = 0;
    for (int set = 0; set < sets; set++) {
        struct question question = kind_question(kind, n, set + 1);
        struct answers *right = new_answers(n, FURTHEST);
        struct answers *found = new_answers(n, FURTHEST);
        struct sorted sorted = sorted_make(&question, c);
        find_algorithm("furthest-hull")->run(&question, right);
        search_edge_cells(&question, &sorted, found);
        edge += wrong_share(found, right, n);
        search_one_corner(&question, &sorted, found);
        double share = wrong_share(found, right, n);
        corner += share;
        broken += share > 0;
        sorted_free(&sorted);
        forget();
    }
    row("%s\t%u\t%d\t%.4g\t%.4g\t%.4g\t%.4g", name, n, sets, c,
        edge / sets, corner / sets, broken / sets);
}

int main(int argc, char **argv)
{
    enum { SMALL = 1000 };
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 5000, 100, MANY);
    int sets = parameter(&e, "SETS", 100, 1, MANY);
    print_header(&e, "name n sets c edge corner broken");
    char name[40];
    for (int k = 0; k < COUNT_OF(kinds); k++) {
        sprintf(name, "wrong_%s", kinds[k]);
        print_wrong(name, kinds[k], n, sqrt(n), 1);
    }
    for (int c = 1; c <= 16; c *= 2) {
        sprintf(name, "sets_c%d", c);
        print_wrong(name, "uniform", SMALL, c, sets);
    }
}
