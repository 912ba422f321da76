// How many branches of the search on sorted points a predictor gets
// wrong, by the length of the history that it looks at. The search of
// nine cells is replayed; its branches (is there another point? is it
// the query? is it nearer?) go to predictors that each keep a table of
// two-bit counters, found by the branch and the last outcomes.
//     predictor [SIDE]
#include "ch04-cell-sort/block.h"
#include "ch04-cell-sort/sorted.h"
#include "common/experiment.h"

enum { LENGTHS = 10, SETS = 2, BITS = 22, PER_CELL = 4 };
enum { MORE, SELF, NEARER, BRANCHES };

static const int lengths[LENGTHS] = {0, 2, 4, 6, 8, 12, 16, 20, 24, 32};

struct predictor {
    int length;     // outcomes of history, 0 .. 63
    uint8_t *state; // of 2^BITS counters: 0, 1 no; 2, 3 yes
    uint64_t wrong[BRANCHES];
};

struct replay {
    uint64_t history; // the last outcomes, the latest in bit 0
    struct predictor predictors[LENGTHS];
};

static uint64_t entry_of(const struct predictor *p, int branch,
                         uint64_t history)
{
    uint64_t mask = (UINT64_C(1) << p->length) - 1;
    uint64_t key = (history & mask) * BRANCHES + branch;
    return (key * UINT64_C(0x9E3779B97F4A7C15)) >> (64 - BITS);
}

static bool decide(struct replay *r, int branch, bool outcome)
{
    for (int k = 0; k < LENGTHS; k++) {
        struct predictor *p = &r->predictors[k];
        uint8_t *state = &p->state[entry_of(p, branch, r->history)];
        p->wrong[branch] += (*state >= 2) != outcome;
        if (outcome)
            *state += *state < 3;
        else
            *state -= *state > 0;
    }
    r->history = r->history << 1 | outcome;
    return outcome;
}

static void replay_cell(struct replay *r, const struct sorted *sorted,
                        struct space space, uint32_t cell,
                        uint32_t query, double *best2)
{
    const struct points p = sorted->points;
    const uint32_t *start = sorted->cells.start;
    for (uint32_t s = start[cell]; decide(r, MORE, s < start[cell + 1]);
         s++)
        if (!decide(r, SELF, s == query)) {
            double d2 = closest2(space, p.x[s] - p.x[query],
                                 p.y[s] - p.y[query]);
            if (decide(r, NEARER, d2 < *best2))
                *best2 = d2;
        }
}

static void replay_query(struct replay *r, const struct sorted *sorted,
                         struct space space, uint32_t query)
{
    const struct grid *grid = &sorted->grid;
    const struct block block = block_of(grid, sorted->points.x[query],
                                        sorted->points.y[query], 1);
    double best2 = INFINITY;
    for (uint32_t k = 0; k < block.y.count; k++)
        for (uint32_t l = 0; l < block.x.count; l++)
            replay_cell(r, sorted, space,
                        range_cell(&grid->y, &block.y, k) *
                                grid->x.count +
                            range_cell(&grid->x, &block.x, l),
                        query, &best2);
}

static void replay_search(struct replay *r, const char *kind,
                          uint32_t n)
{
    struct question question = kind_question(kind, n, 1);
    question.space.geometry = WRAPAROUND;
    struct sorted sorted = sorted_make(&question, PER_CELL);
    *r = (struct replay){0};
    for (int k = 0; k < LENGTHS; k++) {
        r->predictors[k].length = lengths[k];
        r->predictors[k].state = take(1, (size_t)1 << BITS);
    }
    for (uint32_t s = 0; s < n; s++)
        replay_query(r, &sorted, question.space, s);
    sorted_free(&sorted);
}

int main(int argc, char **argv)
{
    static const char *const kinds[SETS] = {"uniform", "lattice"};
    struct experiment e = experiment_begin(argc, argv);
    uint32_t side = parameter(&e, "SIDE", 100, 2, 10000);
    const double n = (double)side * side;
    static struct replay replays[SETS];
    for (int k = 0; k < SETS; k++)
        replay_search(&replays[k], kinds[k], side * side);
    print_header(&e, "name length uniform uniform_ends uniform_nearer "
                     "lattice lattice_ends lattice_nearer");
    for (int l = 0; l < LENGTHS; l++) {
        row_begin("history_%d\t%d", lengths[l], lengths[l]);
        for (int k = 0; k < SETS; k++) {
            const struct predictor *p = &replays[k].predictors[l];
            row_cells(
                "\t%.4g\t%.4g\t%.4g",
                (p->wrong[MORE] + p->wrong[SELF] + p->wrong[NEARER]) /
                    n,
                p->wrong[MORE] / n, p->wrong[NEARER] / n);
        }
        row_end();
    }
}
