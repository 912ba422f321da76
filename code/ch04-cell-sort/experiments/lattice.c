// The same number of cells and distances twice: uniform points, and a
// lattice with four points in every cell. Whatever takes longer with
// the first is not the arithmetic. The candidates are those of batches
// of four. Wraparound, one thread, search only.
//     lattice [SIDE [TRIALS]]
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/experiments/bench.h"
#include "ch04-cell-sort/point_by_point.h"

enum { KINDS = 2, PER_CELL = 4 };

static const char *const kinds[KINDS] = {"uniform", "lattice"};

typedef void search_of(const struct question *question,
                       const struct sorted *sorted,
                       struct answers *answers);

static struct counts count(const struct bench *bench, search_of *search)
{
    struct counts counts = {0};
    struct question question = bench->question;
    question.counts = &counts;
    search(&question, &bench->sorted, bench->answers);
    return counts;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t side = parameter(&e, "SIDE", 320, 2, 30000);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    const uint32_t n = side * side;
    struct bench benches[KINDS];
    struct trial versions[2 * KINDS];
    for (int k = 0; k < KINDS; k++) {
        struct question question = kind_question(kinds[k], n, 1);
        question.space.geometry = WRAPAROUND;
        benches[k] = bench_make(question, PER_CELL);
        versions[2 * k] = bench_trial(&benches[k], "sorted");
        versions[2 * k + 1] = bench_trial(&benches[k], "batches");
    }
    time_in_turn(trials, versions, 2 * KINDS);
    print_header(
        &e, "name n cells distances candidates sorted:3 batches:3");
    for (int k = 0; k < KINDS; k++) {
        struct counts points = count(&benches[k], search_sorted);
        struct counts fours = count(&benches[k], search_batches);
        row_of_times(&versions[2 * k], 2, n, "%s\t%u\t%.4g\t%.4g\t%.4g",
                     kinds[k], n, (double)points.cells / n,
                     (double)points.distances / n,
                     (double)fours.distances / n);
    }
}
