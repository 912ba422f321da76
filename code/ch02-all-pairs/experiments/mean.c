// The mean of the nearest distances: the coursework's running mean, a
// running mean corrected by its difference, and a sum at the end. How
// long each takes per point, and how far it is from the sum in higher
// precision.
//     mean [POINTS [TRIALS]]
#include "ch02-all-pairs/tiles.h"
#include "common/experiment.h"

//> Hold the values to be averaged
struct sample {
    const double *values;
    uint32_t n;
    double mean;
};
//<

static void running(void *context)
{
    struct sample *sample = context;
    double mean = 0;
    //> Update the mean
    for (uint32_t i = 0; i < sample->n; i++)
        mean = (mean * i + sample->values[i]) / (double)(i + 1);
    //<
    sample->mean = mean;
}

static void corrected(void *context)
{
    struct sample *sample = context;
    double mean = 0;
    for (uint32_t i = 0; i < sample->n; i++)
        mean += (sample->values[i] - mean) / (double)(i + 1);
    sample->mean = mean;
}

static void summed(void *context)
{
    struct sample *sample = context;
    double sum = 0;
    //> Add up, divide once
    for (uint32_t i = 0; i < sample->n; i++)
        sum += sample->values[i];
    sample->mean = sum / sample->n;
    //<
}

// Every addition's rounding error is found and added in the end
// (Neumaier 1974).
static double careful_mean(const double *values, uint32_t n)
{
    double sum = 0, lost = 0;
    for (uint32_t i = 0; i < n; i++) {
        double next = sum + values[i];
        if (fabs(sum) >= fabs(values[i]))
            lost += (sum - next) + values[i];
        else
            lost += (values[i] - next) + sum;
        sum = next;
    }
    return (sum + lost) / n;
}

static const struct {
    const char *name;
    void (*work)(void *);
} ways[] = {
    {"running", running}, {"corrected", corrected}, {"summed", summed}};
enum { WAYS = COUNT_OF(ways) };

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 10000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 101, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    question.threads = omp_get_num_procs();
    struct answers *answers = new_answers(n, BOTH);
    tiles(&question, answers);
    for (uint32_t i = 0; i < n; i++)
        answers->nearest2[i] = sqrt(answers->nearest2[i]);
    struct sample samples[WAYS];
    struct trial versions[WAYS];
    for (int w = 0; w < WAYS; w++) {
        samples[w] = (struct sample){answers->nearest2, n, 0};
        versions[w] = (struct trial){ways[w].work, &samples[w]};
    }
    time_in_turn(trials, versions, WAYS);
    double exact = careful_mean(answers->nearest2, n);
    print_header(&e, "name ns:3 error");
    for (int w = 0; w < WAYS; w++) {
        row_begin("%s", ways[w].name);
        row_times(&versions[w].summary, n);
        row_cells("\t%.3g", fabs(samples[w].mean - exact) / exact);
        row_end();
    }
}
