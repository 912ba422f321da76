//> Watch the same work take different times
// Times one sweep over the points again and again, and prints what the
// times come to, the clock's smallest step, and every time in order.
//
//     trials [TRIALS]
#include "common/argument.h"
#include "common/clock.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/geometry.h"
#include "common/report.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

//> Sweep over the points once
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

//> Find the clock's smallest step
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
//<

int main(int argc, char **argv)
{
    fail_as("trials");
    int trials = argument(argc, argv, 1, "TRIALS", 1000, 1, MANY);
    struct points points =
        generate(find_distribution("uniform"), 10000, 1);
    double *times = allocate(trials, sizeof *times);

    //> Time every sweep
    volatile double answer;
    double sum = 0;
    for (int trial = 0; trial < trials; trial++) {
        int64_t start = clock_ns();
        answer = sweep(&points);
        times[trial] = clock_ns() - start;
        sum += times[trial];
    }
    (void)answer;
    //<

    report_provenance(stdout);
    puts("name\ttrial\tns");
    for (int trial = 0; trial < trials; trial++)
        printf("trial\t%d\t%.0f\n", trial + 1, times[trial]);

    //> Sum the trials up
    struct summary s = summarize(times, trials);
    printf("mean\t\t%.6g\n", sum / trials);
    printf("min\t\t%.6g\n", s.min);
    printf("q1\t\t%.6g\n", s.q1);
    printf("median\t\t%.6g\n", s.median);
    printf("q3\t\t%.6g\n", s.q3);
    printf("max\t\t%.6g\n", s.max);
    printf("step\t\t%.6g\n", clock_step());
    //<
    free(times);
    points_free(&points);
    return 0;
}
//<
