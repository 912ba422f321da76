// Nearest and furthest distances of uniform points in both geometries:
// their means over several sets of points, or their histograms.
//     distances means|histogram [POINTS [SETS]]
#include "ch02-all-pairs/experiments/histogram.h"
#include "ch02-all-pairs/tiles.h"

enum { KINDS = 4, MOST_SETS = 100 };

static const char *const kinds[KINDS] = {
    "nearest_standard", "furthest_standard", "nearest_wraparound",
    "furthest_wraparound"};

struct collection {
    double mean[KINDS][MOST_SETS]; // of each set of points
    double same[MOST_SETS]; // share whose nearest is furthest, wrapped
    struct histogram histogram[KINDS];
};

static void collect(struct collection *c, uint32_t n, int set)
{
    struct question question = uniform_question(STANDARD, n, set + 1);
    question.threads = omp_get_num_procs();
    struct answers *answers = new_answers(n, BOTH);
    for (int kind = 0; kind < KINDS; kind += 2) {
        question.space.geometry = kind == 0 ? STANDARD : WRAPAROUND;
        tiles(&question, answers);
        double nearest = 0, furthest = 0, same = 0;
        for (uint32_t i = 0; i < n; i++) {
            double near = sqrt(answers->nearest2[i]);
            double far = sqrt(answers->furthest2[i]);
            histogram_add(&c->histogram[kind], near);
            histogram_add(&c->histogram[kind + 1], far);
            nearest += near;
            furthest += far;
            same += answers->nearest[i] == answers->furthest[i];
        }
        c->mean[kind][set] = nearest / n;
        c->mean[kind + 1][set] = furthest / n;
        if (question.space.geometry == WRAPAROUND)
            c->same[set] = same / n;
    }
    forget();
}

static void print_mean(const char *name, const double *values, int sets)
{
    double sum = 0, squares = 0;
    for (int set = 0; set < sets; set++)
        sum += values[set];
    for (int set = 0; set < sets; set++)
        squares +=
            (values[set] - sum / sets) * (values[set] - sum / sets);
    row("%s\t%.7g\t%.2g", name, sum / sets,
        sets > 1 ? sqrt(squares / (sets - 1)) : 0);
}

static void print_means(const struct collection *c, int sets)
{
    double edge[MOST_SETS];
    for (int kind = 0; kind < KINDS; kind++)
        print_mean(kinds[kind], c->mean[kind], sets);
    for (int set = 0; set < sets; set++)
        edge[set] = c->mean[0][set] - c->mean[2][set];
    print_mean("edge", edge, sets);
    print_mean("same", c->same, sets);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const bool means = means_wanted(&e);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    int sets = parameter(&e, "SETS", 3, 1, MOST_SETS);

    static struct collection c;
    double scale = 1 / sqrt(n);
    c.histogram[0].high = c.histogram[2].high = 1.8 * scale;
    c.histogram[1].low = 0.7;
    c.histogram[1].high = c.histogram[3].high = sqrt(2);
    c.histogram[3].low = sqrt(2) - 1.4 * scale;
    for (int set = 0; set < sets; set++)
        collect(&c, n, set);
    print_header(&e,
                 means ? "name mean spread"
                       : "nearest_standard_at nearest_standard"
                         " furthest_standard_at furthest_standard"
                         " nearest_wraparound_at nearest_wraparound"
                         " furthest_wraparound_at furthest_wraparound");
    if (means)
        print_means(&c, sets);
    else
        print_histograms(c.histogram, KINDS);
}
