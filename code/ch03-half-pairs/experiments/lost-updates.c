// What becomes of the triangular loop when its rows are handed to
// several threads and nothing else is done: all of them change the same
// answers, unguarded. A data race, on purpose; chapter 5 has the only
// other one in this book. Prints how many answers came out wrong, for
// up to LARGEST points in two arrangements.
//     lost-updates [RUNS [LARGEST]]
#include "ch03-half-pairs/triangle.h"
#include "common/experiment.h"

//> Share out the rows and hope
static void triangle_racing(const struct question *question,
                            struct answers *answers)
{
    uint32_t n = question->points.n;
    triangle_begin(answers, n);
#pragma omp parallel for num_threads(question->threads) \
    schedule(static, 1)
    for (uint32_t i = 0; i < n; i++)
        triangle_row(question, answers, i);
}
//<

//> Build houses along a street
// In the order of their numbers: every row is a step nearer than the
// one before to all houses after it, so that every pair improves the
// nearest of its second end.
static void street(struct points points)
{
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = (i + 0.5) / points.n;
        points.y[i] = 0.5;
    }
}
//<

static int wrong_answers(const struct answers *found,
                         const struct answers *right, uint32_t n)
{
    int wrong = 0;
    for (uint32_t i = 0; i < n; i++) {
        wrong += found->nearest2[i] != right->nearest2[i];
        wrong += found->furthest2[i] != right->furthest2[i];
    }
    return wrong;
}

static void race(const char *name, struct question question, int runs)
{
    const uint32_t n = question.points.n;
    struct answers *right = new_answers(n, BOTH);
    struct answers *found = new_answers(n, BOTH);
    triangle(&question, right);
    question.threads = 2;
    double *wrong = take(runs, sizeof *wrong), sum = 0;
    int bad = 0;
    for (int run = 0; run < runs; run++) {
        triangle_racing(&question, found);
        wrong[run] = wrong_answers(found, right, n);
        sum += wrong[run];
        bad += wrong[run] > 0;
    }
    struct summary summary = summarize(wrong, runs);
    row("%s_%u\t%u\t%d\t%d\t%g\t%g\t%g\t%g\t%g", name, n, n, runs, bad,
        sum / runs, summary.median, summary.q1, summary.q3,
        summary.max);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    int runs = parameter(&e, "RUNS", 100, 1, MANY);
    uint32_t largest = parameter(&e, "LARGEST", 2000, 125, MANY);
    print_header(&e,
                 "name n runs bad_runs mean_wrong wrong:3 wrong_most");
    for (uint32_t n = 125; n <= largest; n *= 2) {
        struct question question = uniform_question(STANDARD, n, 1);
        race("uniform", question, runs);
        street(question.points);
        race("street", question, runs);
        forget();
    }
}
