// Every line of the search by primitives: how many elements it sees, as
// counted, what an element needs of the primitives, and what that costs
// at prices of the same run, measured on arrays as large as those of
// the innermost loop and, for routes to anywhere, as the points. Then
// what each loop costs by its lines, and by the clock.
//     bill [POINTS [TRIALS]]
#include "ch08-vector-spiral/by_primitives.h"
#include "ch08-vector-spiral/experiments/small_prices.h"
#include "ch08-vector-spiral/lockstep.h"
#include "ch08-vector-spiral/vector_spiral.h"

enum { IN_LAYERS, IN_CELLS, IN_POINTS, SORT, WHOLE, LOOPS };

// Of the arrays that the loop over points goes through, for each task.
enum { BYTES_LOOKED = 89 };

static const char *const loop_names[LOOPS] = {[IN_LAYERS] = "layers",
                                              [IN_CELLS] = "cells",
                                              [IN_POINTS] = "points",
                                              [SORT] = "sort",
                                              [WHOLE] = "whole"};

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
        seeking += t->phase_one[k] / n;
        looking += t->phase_two[k] / n;
    }
    const double relisted = t->listed / n - seeking;
    const double steps = t->bound_steps / n, points = t->compared / n;
    const struct line all[LINES] = {
        {"count", SORT, 1, .bytes = 32, .operations = 12, .far_in32 = 1,
         .far_out = 1},
        {"sum", SORT, 1, .scan = 1},
        {"place", SORT, 1, .bytes = 4, .far_in32 = 1, .far_out = 2},
        {"begin", IN_LAYERS, 1, .bytes = 88, .operations = 20,
         .far_in = 2},
        {"seek", IN_LAYERS, seeking, .bytes = 18, .operations = 6,
         .in32 = 1, .out = 1, .pack = 7},
        {"list_all", IN_LAYERS, 1, .bytes = 32},
        {"bound", IN_LAYERS, steps, .bytes = 6, .operations = 9,
         .in = 3, .in32 = 1, .out = 1, .pack = 1},
        {"list_again", IN_LAYERS, relisted, .bytes = 22,
         .operations = 6, .pack = 7},
        {"furthest", IN_LAYERS, looking, .bytes = 16, .operations = 4},
        {"answer", IN_LAYERS, 1, .far_out = 2},
        {"take_step", IN_CELLS, t->tried / n, .bytes = 26,
         .operations = 6, .pack = 2},
        {"keep_entered", IN_CELLS, t->visited / n, .bytes = 10,
         .operations = 1, .in32 = 2, .pack = 3},
        {"cell_starts", IN_CELLS, t->cell_steps / n, .starts = 10},
        {"compare", IN_POINTS, points, .bytes = 68, .operations = 15,
         .in = 5, .in32 = 2, .out = 2},
        {"next", IN_POINTS, points, .bytes = 14, .operations = 2,
         .pack = 3},
        {"point_starts", IN_POINTS, t->point_rounds / n, .starts = 14},
    };
    for (int k = 0; k < LINES; k++)
        lines[k] = all[k];
}

// An addition moves 32 bytes: what it writes it has to read before.
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
    return line->bytes / 32.0 * near[ELEMENTWISE].median +
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

// The time in each of the three loops, and how often the search came
// to it. The kernels of the search tell: a loop begins or ends where
// one is called, or leaves no visits behind.
static struct watch {
    const struct spiral_kernels *kernels;
    int loop;
    int64_t since, ns[SORT];
    uint64_t entries[SORT];
} watch;

static void watch_loop(int loop)
{
    int64_t now = clock_ns();
    watch.ns[watch.loop] += now - watch.since;
    watch.since = now;
    watch.loop = loop;
    watch.entries[loop]++;
}

static void enter_watched(const struct map *map, struct strip *strip,
                          const struct tasks *tasks, int32_t dx,
                          int32_t dy)
{
    watch_loop(IN_CELLS);
    watch.kernels->enter_cells(map, strip, tasks, dx, dy);
    watch_loop(strip->here.n > 0 ? IN_POINTS : IN_LAYERS);
}

static void compare_watched(const struct map *map, struct strip *strip)
{
    watch.kernels->compare_points(map, strip);
    if (strip->here.n == 0)
        watch_loop(IN_LAYERS);
}

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
                       struct answers *answers, double reading,
                       double ns[static LOOPS], struct tally *tally)
{
    const struct spiral_kernels *kernels =
        &spiral_by_primitives[isa_chosen()];
    const struct spiral_kernels watched = {kernels->isa, enter_watched,
                                           compare_watched};
    struct strip_plan plan = {kernels, STRIP, tally};
    int64_t begin = clock_ns();
    struct grid grid = grid_fit(question, 1);
    struct cells cells = cells_sort(&grid, question->points);
    int64_t sorted = clock_ns();
    search_in_lockstep(question, &grid, &cells, &plan, answers);
    int64_t end = clock_ns();
    plan.kernels = &watched;
    watch = (struct watch){.kernels = kernels, .since = end};
    search_in_lockstep(question, &grid, &cells, &plan, answers);
    for (int k = 0; k < SORT; k++)
        ns[k] = watch.ns[k] - reading * watch.entries[k];
    ns[SORT] = sorted - begin;
    ns[WHOLE] = end - begin;
    cells_free(&cells);
    grid_free(&grid);
}

static void time_in_trials(const struct question *question, int trials,
                           struct summary loops_ns[static LOOPS],
                           struct tally *tally)
{
    struct answers *answers = new_answers(question->points.n, BOTH);
    double reading = watch_price(), ns[LOOPS];
    double *values = take((size_t)trials * LOOPS, sizeof *values);
    for (int trial = -1; trial < trials; trial++) { // the first warms
        time_loops(question, answers, reading, ns, tally);
        for (int k = 0; k < LOOPS && trial >= 0; k++)
            values[k * trials + trial] = ns[k];
    }
    for (int k = 0; k < LOOPS; k++)
        loops_ns[k] = summarize(values + k * trials, trials);
}

static void print_price(const char *where, const char *work,
                        double price)
{
    row("%s%s\tprice\t1\t%.4g\tnan\tnan\tnan\tnan", where, work, price);
}

static void print_bill(const struct line *lines,
                       const struct prices *prices,
                       const struct summary *ns, double n)
{
    double sums[LOOPS] = {0};
    for (int k = 0; k < WORKS; k++) {
        print_price("near_", work_names[k], prices->near[0][k].median);
        print_price("far_", work_names[k], prices->far[0][k].median);
    }
    print_price("operation", "", prices->operation);
    print_price("start", "", prices->start);
    for (int k = 0; k < LINES; k++) {
        double price = price_of(&lines[k], prices);
        double whole = lines[k].elements * price;
        row("%s\t%s\t%.5g\t%.4g\t%.4g\tnan\tnan\tnan", lines[k].name,
            loop_names[lines[k].loop], lines[k].elements, price, whole);
        sums[lines[k].loop] += whole;
        sums[WHOLE] += whole;
    }
    for (int k = 0; k < LOOPS; k++) {
        row_begin("%s\tsum\t1\t%.4g\t%.4g", loop_names[k], sums[k],
                  sums[k]);
        row_times(&ns[k], n);
        row_end();
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 1000, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
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
    print_header(&e, "name loop elements price predicted measured:3");
    print_bill(lines, &prices, ns, n);
}
