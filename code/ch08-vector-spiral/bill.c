//> Write the bill of the march
// Every line of the march by primitives: how many elements it sees, as
// counted, what an element needs of the primitives, and what that costs
// at prices of the same run, measured on arrays as large as those of
// the innermost loop and, for routes to anywhere, as the points. Then
// what each loop costs by its lines, and by the clock.
//
//     bill [POINTS [TRIALS]]
#include "ch02-all-pairs/timing.h"
#include "ch06-pack-scan/workload.h"
#include "ch08-vector-spiral/by_primitives.h"
#include "ch08-vector-spiral/march.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/random.h"
#include "common/report.h"
#include <stdio.h>
#include <stdlib.h>

enum { SORT = PHASES, WHOLE, LOOPS };

// Of the arrays that the loop over points goes through, for each task.
enum { BYTES_LOOKED = 89 };

static const char *const loop_names[LOOPS] = {[IN_LAYERS] = "layers",
                                              [IN_CELLS] = "cells",
                                              [IN_POINTS] = "points",
                                              [SORT] = "sort",
                                              [WHOLE] = "whole"};

//> Say what an element needs
// The bytes that elementwise loops move and the operations they do on
// them; routes of doubles and of 32-bit numbers, in and out; scans and
// packs; routes to anywhere. Or how many loops begin.
struct line {
    const char *name;
    int loop;
    double elements; // a point
    int bytes, operations, in, in32, out, scan, pack, far_in, far_in32,
        far_out, starts;
};
enum { LINES = 16 };

static void list_lines(const struct tally *t, double n,
                       struct line lines[static LINES])
{
    double seeking = 0, looking = 0;
    for (int k = 0; k < LAYERS_TALLIED; k++) {
        seeking += t->seeking[k] / n;
        looking += t->looking[k] / n;
    }
    const double relisted = t->listed / n - seeking;
    const double steps = t->steps / n, points = t->points / n;
    const struct line all[LINES] = {
        {"count", SORT, 1, .bytes = 36, .operations = 12, .far_in32 = 1,
         .far_out = 1},
        {"sum", SORT, 1, .scan = 1},
        {"place", SORT, 1, .bytes = 4, .far_in32 = 1, .far_out = 2},
        {"begin", IN_LAYERS, 1, .bytes = 52, .operations = 20,
         .far_in = 2},
        {"seek", IN_LAYERS, seeking, .bytes = 17, .operations = 6,
         .in32 = 1, .out = 1, .pack = 7},
        {"draw", IN_LAYERS, 1, .bytes = 16},
        {"step", IN_LAYERS, steps, .bytes = 5, .operations = 9, .in = 3,
         .in32 = 1, .out = 1, .pack = 1},
        {"relist", IN_LAYERS, relisted, .bytes = 21, .operations = 6,
         .pack = 7},
        {"round", IN_LAYERS, looking, .bytes = 16, .operations = 4},
        {"answer", IN_LAYERS, 1, .far_out = 2},
        {"go", IN_CELLS, t->tried / n, .bytes = 21, .operations = 6,
         .pack = 2},
        {"stay", IN_CELLS, t->looked / n, .bytes = 9, .operations = 1,
         .in32 = 2, .pack = 3},
        {"enters", IN_CELLS, t->enters / n, .starts = 10},
        {"compare", IN_POINTS, points, .bytes = 68, .operations = 15,
         .in = 5, .in32 = 2, .out = 2},
        {"on", IN_POINTS, points, .bytes = 13, .operations = 2,
         .pack = 3},
        {"looks", IN_POINTS, t->looks / n, .starts = 14},
    };
    for (int k = 0; k < LINES; k++)
        lines[k] = all[k];
}
//<

//> Price a line
// An addition moves three doubles.
struct prices {
    struct summary near[1][WORKS], far[1][WORKS]; // ns an element
    double operation;                             // ns in a register
    double start;                                 // ns a loop
};

static double price_of(const struct line *line,
                       const struct prices *prices)
{
    const struct summary *near = prices->near[0];
    const struct summary *far = prices->far[0];
    return line->bytes / 24.0 * near[ELEMENTWISE].median +
           line->operations * prices->operation +
           line->in * near[GATHER_AT_RANDOM].median +
           line->in32 * near[GATHER32_AT_RANDOM].median +
           line->out * near[SCATTER_AT_RANDOM].median +
           line->scan * near[SCAN].median +
           line->pack * near[PACK].median +
           line->far_in * far[GATHER_AT_RANDOM].median +
           line->far_in32 * far[GATHER32_AT_RANDOM].median +
           line->far_out * far[SCATTER_AT_RANDOM].median +
           line->starts * prices->start;
}
//<

//> Price an operation in a register
// Of sixteen, from the load of a number to its store.
enum { NUMBERS_OPERATED = 1024, OPERATIONS = 16, ROUNDS = 512 };

static void operate(void *context)
{
    double *x = context;
    for (int round = 0; round < ROUNDS; round++)
#pragma omp simd
        for (int i = 0; i < NUMBERS_OPERATED; i++) {
            double y = x[i];
            for (int k = 0; k < OPERATIONS / 2; k++)
                y = y * y + 0.125;
            x[i] = y;
        }
}

static double operation_price(int trials)
{
    double x[NUMBERS_OPERATED] = {0};
    struct summary ns = time_trials(trials, operate, x);
    return ns.median / NUMBERS_OPERATED / OPERATIONS / ROUNDS;
}
//<

//> Price the start of a loop
// Of short loops, each as long as nobody foresees: what they take
// beyond the price of their elements.
struct starts {
    const struct primitives *p;
    uint32_t *length;
};
enum { STARTS = 1 << 16, MOST = 32 };

static void start_loops(void *context)
{
    const struct starts *starts = context;
    double from[MOST] = {0}, to[MOST];
    uint32_t index[MOST], kept[MOST + SPILL];
    uint8_t keep[MOST];
    for (uint32_t i = 0; i < MOST; i++)
        index[i] = i, keep[i] = i & 1;
    for (uint32_t k = 0; k < STARTS; k++) {
        starts->p->gather(to, from, index, starts->length[k]);
        starts->p->pack(kept, index, keep, starts->length[k]);
    }
}

static double start_price(const struct primitives *p, int trials,
                          const struct summary near[WORKS])
{
    struct random random = {1};
    struct starts starts = {p, allocate(STARTS, sizeof(uint32_t))};
    double elements = 0;
    for (uint32_t k = 0; k < STARTS; k++) {
        starts.length[k] = random_bits(&random) % MOST;
        elements += starts.length[k];
    }
    struct summary ns = time_trials(trials, start_loops, &starts);
    free(starts.length);
    return (ns.median - elements * (near[GATHER_IN_ORDER].median +
                                    near[PACK].median)) /
           (2.0 * STARTS);
}
//<

//> Time every loop
// What reading the watch takes, is taken off.
static double watch_price(void)
{
    enum { READINGS = 100000 };
    int64_t begin = clock_ns();
    for (int k = 0; k < READINGS; k++)
        clock_ns();
    return (double)(clock_ns() - begin) / READINGS;
}

static void time_loops(const struct question *question,
                       struct answers *answers,
                       const struct loops *loops, double reading,
                       double ns[static LOOPS], struct tally *tally)
{
    struct watch watch = {0};
    int64_t begin = clock_ns();
    struct grid grid = grid_fit(question, 1);
    struct cells cells = cells_sort(&grid, question->points);
    int64_t sorted = clock_ns();
    march(question, &grid, &cells, loops, STRIP, answers, tally, NULL);
    int64_t end = clock_ns();
    watch.since = end;
    march(question, &grid, &cells, loops, STRIP, answers, tally,
          &watch);
    for (int k = 0; k < PHASES; k++)
        ns[k] = watch.ns[k] - reading * watch.turns[k];
    ns[SORT] = sorted - begin;
    ns[WHOLE] = end - begin;
    cells_free(&cells);
    grid_free(&grid);
}

static void time_in_trials(const struct question *question, int trials,
                           struct summary loops_ns[static LOOPS],
                           struct tally *tally)
{
    struct answers answers = answers_allocate(question->points.n);
    struct loops loops = loops_by_primitives(isa_chosen());
    double reading = watch_price(), ns[LOOPS];
    double *values = allocate((size_t)trials * LOOPS, sizeof *values);
    for (int trial = -1; trial < trials; trial++) { // the first warms
        time_loops(question, &answers, &loops, reading, ns, tally);
        for (int k = 0; k < LOOPS && trial >= 0; k++)
            values[k * trials + trial] = ns[k];
    }
    for (int k = 0; k < LOOPS; k++)
        loops_ns[k] = summarize(values + k * trials, trials);
    free(values);
    answers_free(&answers);
}
//<

//> Print the bill of the march
static void print_line(const char *name, const char *loop,
                       double elements, double price)
{
    printf("%s\t%s\t%.5g\t%.4g\t%.4g", name, loop, elements, price,
           elements * price);
}

static void print_bill(const struct line *lines,
                       const struct prices *prices,
                       const struct summary *ns, double n)
{
    double sums[LOOPS] = {0};
    for (int k = 0; k < WORKS; k++)
        printf("near_%s\tprice\t1\t%.4g\tnan\tnan\tnan\tnan\n"
               "far_%s\tprice\t1\t%.4g\tnan\tnan\tnan\tnan\n",
               work_names[k], prices->near[0][k].median, work_names[k],
               prices->far[0][k].median);
    printf("operation\tprice\t1\t%.4g\tnan\tnan\tnan\tnan\n"
           "start\tprice\t1\t%.4g\tnan\tnan\tnan\tnan\n",
           prices->operation, prices->start);
    for (int k = 0; k < LINES; k++) {
        double price = price_of(&lines[k], prices);
        print_line(lines[k].name, loop_names[lines[k].loop],
                   lines[k].elements, price);
        puts("\tnan\tnan\tnan");
        sums[lines[k].loop] += lines[k].elements * price;
        sums[WHOLE] += lines[k].elements * price;
    }
    for (int k = 0; k < LOOPS; k++) {
        print_line(loop_names[k], "sum", 1, sums[k]);
        print_summary(&ns[k], n);
        puts("");
    }
}
//<

int main(int argc, char **argv)
{
    fail_as("bill");
    uint32_t n = argument(argc, argv, 1, "POINTS", 20000, 1000, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    const struct primitives *chosen = primitives(isa_chosen());
    struct prices prices;
    price_tables(trials, STRIP * BYTES_LOOKED, &chosen, 1, prices.near);
    price_tables(trials, n * 2 * sizeof(double), &chosen, 1,
                 prices.far);
    prices.operation = operation_price(trials);
    prices.start = start_price(chosen, trials, prices.near[0]);
    struct summary ns[LOOPS];
    struct tally tally;
    time_in_trials(&question, trials, ns, &tally);
    struct line lines[LINES];
    list_lines(&tally, n, lines);
    report_provenance(stdout);
    puts("name\tloop\telements\tprice\tpredicted"
         "\tmeasured\tmeasured_q1\tmeasured_q3");
    print_bill(lines, &prices, ns, n);
    points_free(&question.points);
    return 0;
}
//<
