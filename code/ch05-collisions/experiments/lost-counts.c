// Counts points in some 576 cells without any care: in groups of lanes
// that first read all counts, then write them all, and on two threads.
// The threads race, on purpose, like those of chapter 3. Prints what
// should have been counted in every cell, and what was.
//     lost-counts [POINTS]
#include "ch04-cell-sort/grid.h"
#include "common/experiment.h"

enum { CELLS = 576, MOST_LANES = 1024, WAYS = 5, ROUNDS = 100 };

//> Count in lanes and hope
static void count_in_lanes(const uint32_t *cell_id, uint32_t n,
                           uint32_t lanes, uint32_t *count)
{
    uint32_t seen[MOST_LANES];
    for (uint32_t i = 0; i + lanes <= n; i += lanes) {
        for (uint32_t k = 0; k < lanes; k++)
            seen[k] = count[cell_id[i + k]];
        for (uint32_t k = 0; k < lanes; k++)
            count[cell_id[i + k]] = seen[k] + 1;
    }
}
//<

//> Count on two threads and hope
// So many rounds that both threads are sure to be at it together.
static void count_racing(const uint32_t *cell_id, uint32_t n,
                         uint32_t *count)
{
#pragma omp parallel num_threads(2)
    for (int round = 0; round < ROUNDS; round++)
#pragma omp for
        for (uint32_t i = 0; i < n; i++)
            count[cell_id[i]]++;
}
//<

// With names, so that the text can quote the first row, the sums. Of
// the threads, the mean of their rounds.
static void print_counts(uint32_t m, uint32_t *count)
{
    const double rounds[WAYS] = {1, 1, 1, 1, ROUNDS};
    row_begin("all");
    for (int way = 0; way < WAYS; way++) {
        uint64_t sum = 0;
        for (uint32_t cell = 0; cell < m; cell++)
            sum += count[way * m + cell];
        row_cells("\t%.9g", sum / rounds[way]);
    }
    row_end();
    for (uint32_t cell = 0; cell < m; cell++) {
        row_begin("cell_%u", cell);
        for (int way = 0; way < WAYS; way++)
            row_cells("\t%.9g", count[way * m + cell] / rounds[way]);
        row_end();
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1 << 20, MOST_LANES,
                           UINT32_MAX / ROUNDS);
    n -= n % MOST_LANES; // groups without a rest
    struct question question = kind_question("clustered", n, 2);
    struct grid grid = grid_fit(&question, (double)n / CELLS);
    const uint32_t m = grid_cells(&grid);
    uint32_t *cell_id = take(n, sizeof *cell_id);
    uint32_t *count = take((size_t)WAYS * m, sizeof *count);
    find_cell_ids(&grid, question.points, 0, n, cell_id);
    count_in_lanes(cell_id, n, 1, count);
    count_in_lanes(cell_id, n, 8, count + m);
    count_in_lanes(cell_id, n, 64, count + 2 * m);
    count_in_lanes(cell_id, n, 1024, count + 3 * m);
    count_racing(cell_id, n, count + 4 * m);
    print_header(&e, "name right lanes8 lanes64 lanes1024 threads2");
    print_counts(m, count);
}
