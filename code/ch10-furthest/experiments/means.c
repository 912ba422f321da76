// The mean distances of uniform points in both geometries, with the
// time that both answers took on all processors; or the histogram of
// the furthest.
//     means means|histogram [POINTS [SETS]]
#include "ch02-all-pairs/experiments/histogram.h"

enum { MOST_SETS = 100 };

// By the fastest algorithm for each; once, if that is the same.
static void answer_both(const struct question *question,
                        struct answers *answers)
{
    enum geometry geometry = question->space.geometry;
    const struct algorithm *near = fastest_algorithm(geometry, NEAREST);
    const struct algorithm *far = fastest_algorithm(geometry, FURTHEST);
    near->run(question, answers);
    if (far != near)
        far->run(question, answers);
}

struct sums {
    double nearest, furthest; // distances
    double ns[MOST_SETS];     // for each set
};

static void add_set(enum geometry geometry, uint32_t n, int set,
                    struct sums *sums, struct histogram *histogram)
{
    struct question question = uniform_question(geometry, n, set + 1);
    struct workspace workspace = {0};
    question.workspace = &workspace;
    question.threads = omp_get_num_procs();
    struct answers *answers = new_answers(n, BOTH);
    answer_both(&question, answers);
    int64_t start = clock_ns();
    answer_both(&question, answers);
    sums->ns[set] = clock_ns() - start;
    for (uint32_t i = 0; i < n; i++) {
        double far = sqrt(answers->furthest2[i]);
        sums->nearest += sqrt(answers->nearest2[i]);
        sums->furthest += far;
        histogram_add(histogram, far);
    }
    workspace_free(&workspace);
    forget();
}

static void print_means(struct sums sums[2], uint32_t n, int sets)
{
    const double points = (double)n * sets;
    for (int g = 0; g < 2; g++) {
        struct summary ns = summarize(sums[g].ns, sets);
        row_begin("%s_%u\t%u\t%d\t%d\t%.7g\t%.7g",
                  g ? "wraparound" : "standard", n, n, sets,
                  omp_get_num_procs(), sums[g].nearest / points,
                  sums[g].furthest / points);
        row_times(&ns, 1);
        row_end();
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const bool means = means_wanted(&e);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    int sets = parameter(&e, "SETS", 3, 1, MOST_SETS);
    static struct sums sums[2];
    static struct histogram furthest[2];
    furthest[0].low = 0.7;
    furthest[1].low = sqrt(2) - 1.4 / sqrt(n);
    furthest[0].high = furthest[1].high = sqrt(2);
    for (int set = 0; set < sets; set++) {
        add_set(STANDARD, n, set, &sums[0], &furthest[0]);
        add_set(WRAPAROUND, n, set, &sums[1], &furthest[1]);
    }
    print_header(
        &e, means ? "name n sets threads nearest furthest ns:3"
                  : "standard_at standard wraparound_at wraparound");
    if (means)
        print_means(sums, n, sets);
    else
        print_histograms(furthest, 2);
}
