// How many corners the hull of uniform points has, averaged over many
// sets, beside the expectation of Renyi and Sulanke (1963); how many of
// them are the furthest of any point; and the corners of a circle's
// points.
//     corners [MOST [SETS]]
#include "ch10-furthest/furthest_hull.h"
#include "common/experiment.h"

static double corners_expected(double n)
{
    const double gamma = 0.57721566490153286; // Euler's constant
    return 8.0 / 3 * (log(n) + gamma - log(2));
}

struct tally {
    double corners, furthest; // those that are the furthest of a point
};

static void count_corners(const struct question *question,
                          struct tally *tally)
{
    const uint32_t n = question->points.n;
    struct answers *answers = new_answers(n, FURTHEST);
    struct workspace workspace = {0};
    struct corners corners = corners_find(question, &workspace);
    search_corners(question, &corners, answers);
    uint8_t *furthest = take(n, 1);
    for (uint32_t i = 0; i < n; i++)
        furthest[answers->furthest[i]] = 1;
    for (uint32_t i = 0; i < n; i++)
        tally->furthest += furthest[i];
    tally->corners += corners.points.n;
    workspace_free(&workspace);
}

static void print_count(const char *kind, uint32_t n, int sets)
{
    struct tally tally = {0, 0};
    for (int set = 0; set < sets; set++) {
        struct question question = kind_question(kind, n, set + 1);
        count_corners(&question, &tally);
        forget();
    }
    row("%s_%u\t%u\t%d\t%.5g\t%.5g\t%.4g", kind, n, n, sets,
        tally.corners / sets, corners_expected(n),
        tally.furthest / sets);
}

int main(int argc, char **argv)
{
    enum { FEW = 10000 };
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 10000, 100, MANY);
    int sets = parameter(&e, "SETS", 20, 1, MANY);
    print_header(&e, "name n sets corners expected asked");
    for (uint64_t n = 100; n <= most; n *= 10)
        print_count("uniform", n,
                    n > FEW ? 1 + sets * FEW / n : (uint32_t)sets);
    for (uint64_t n = 100; n <= FEW; n *= 10)
        print_count("circle", n, 1);
}
