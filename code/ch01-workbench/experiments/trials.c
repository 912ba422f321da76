// Times one sweep over the points again and again, and prints what the
// times come to, the clock's smallest step, and every time in order.
//     trials [TRIALS]
#include "common/experiment.h"

//> Sweep over the points
static double sweep(const struct points *points)
{
    double nearest2 = INFINITY;
    for (uint32_t j = 1; j < points->n; j++) {
        double d2 = distance2(points->x[0] - points->x[j],
                              points->y[0] - points->y[j]);
        if (d2 < nearest2)
            nearest2 = d2;
    }
    return nearest2;
}
//<

static double clock_step(void)
{
    double step = INFINITY;
    for (int trial = 0; trial < 100000; trial++) {
        int64_t start = clock_ns(), now;
        while ((now = clock_ns()) == start)
            ;
        if (now - start < step)
            step = now - start;
    }
    return step;
}

static void print_summary(double *times, int trials)
{
    double sum = 0;
    for (int trial = 0; trial < trials; trial++)
        sum += times[trial];
    struct summary s = summarize(times, trials);
    row("mean\t\t%.6g", sum / trials);
    row("min\t\t%.6g", s.min);
    row("q1\t\t%.6g", s.q1);
    row("median\t\t%.6g", s.median);
    row("q3\t\t%.6g", s.q3);
    row("max\t\t%.6g", s.max);
    row("step\t\t%.6g", clock_step());
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    int trials = parameter(&e, "TRIALS", 1000, 1, MANY);
    const struct points points =
        uniform_question(STANDARD, 10000, 1).points;
    double *times = take(trials, sizeof *times);

    //> Time every sweep
    volatile double answer;
    for (int trial = 0; trial < trials; trial++) {
        int64_t start = clock_ns();
        answer = sweep(&points);
        times[trial] = clock_ns() - start;
    }
    (void)answer;
    //<

    print_header(&e, "name trial ns");
    for (int trial = 0; trial < trials; trial++)
        row("trial\t%d\t%.0f", trial + 1, times[trial]);
    print_summary(times, trials);
}
