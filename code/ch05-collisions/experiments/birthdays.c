// For groups of 8, 16, 32, ... lanes and all kinds of points: how many
// pairs of lanes collide and how many lanes lose, beside what is to be
// expected if the points come in random order. On average over several
// sets of points.
//     birthdays [POINTS [SETS]]
#include "ch05-collisions/groups.h"
#include "common/experiment.h"

enum { SETS = 8 }; // of clusters, shown one by one

struct tally {
    double cells, others, pairs, losers;
    double pairs_expected, losers_expected;
};

// count is all zeros before and after.
static double pairs_of(const uint32_t *cell_id, uint32_t n,
                       uint32_t lanes, uint32_t *count)
{
    double pairs = 0;
    for (uint32_t begin = 0; begin < n; begin += lanes) {
        uint32_t end = n - begin < lanes ? n : begin + lanes;
        for (uint32_t i = begin; i < end; i++)
            pairs += count[cell_id[i]]++;
        for (uint32_t i = begin; i < end; i++)
            count[cell_id[i]] = 0;
    }
    return pairs;
}

// A group is lanes of the n points, drawn without putting back; k
// points are in this cell. All of them lose but one for each group that
// has any.
static double losers_expected(double n, double k, double lanes)
{
    double none = 1; // the probability that a group has none
    for (double j = 0; j < k && none > 0; j++)
        none *= fmax(0, 1 - lanes / (n - j));
    return k - n / lanes * (1 - none);
}

// Points in their cells.
struct set {
    uint32_t n, cells, *cell_id;
    uint32_t *count; // all zeros between two uses
};

static void add_set(struct tally *tally, const struct set *set,
                    uint32_t lanes)
{
    struct groups groups = groups_allocate(lanes, set->cells);
    tally->pairs += pairs_of(set->cell_id, set->n, lanes, set->count);
    tally->losers +=
        groups_count(&groups, set->cell_id, set->n, set->count);
    double others = 0;
    for (uint32_t cell = 0; cell < set->cells; cell++) {
        double k = set->count[cell];
        others += k * (k - 1) / set->n;
        tally->losers_expected += losers_expected(set->n, k, lanes);
        set->count[cell] = 0;
    }
    tally->others += others;
    tally->pairs_expected += others * (lanes - 1) / 2;
    tally->cells += set->cells;
    groups_free(&groups);
}

static struct set make_set(const char *kind, uint32_t n, uint64_t seed)
{
    struct question question = kind_question(kind, n, seed);
    struct grid grid = grid_fit(&question, 2);
    struct set set = {n, grid_cells(&grid), take(n, sizeof(uint32_t)),
                      take(grid_cells(&grid), sizeof(uint32_t))};
    find_cell_ids(&grid, question.points, 0, n, set.cell_id);
    grid_free(&grid);
    return set;
}

struct range {
    uint32_t first, last;
};

static void print_tally(const char *name, const char *kind, uint32_t n,
                        struct range seeds, struct range lanes)
{
    struct tally tallies[32] = {0}, *t = tallies;
    const int sets = seeds.last - seeds.first + 1;
    for (uint32_t seed = seeds.first; seed <= seeds.last; seed++) {
        struct set set = make_set(kind, n, seed);
        t = tallies;
        for (uint32_t l = lanes.first; l <= lanes.last; l *= 2)
            add_set(t++, &set, l);
        forget();
    }
    t = tallies;
    for (uint32_t l = lanes.first; l <= lanes.last; l *= 2, t++)
        row("%s_%u_%u\t%u\t%.0f\t%u\t%.4g\t%.6g\t%.6g\t%.6g\t%.6g",
            name, l, n, n, t->cells / sets, l, t->others / sets,
            t->pairs / sets, t->pairs_expected / sets, t->losers / sets,
            t->losers_expected / sets);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1 << 14, 1 << 10, 1 << 25);
    int sets = parameter(&e, "SETS", 10, 1, MANY);
    while (n & (n - 1))
        n &= n - 1; // a power of two, so that all groups are full
    print_header(
        &e, "name n cells lanes others pairs pairs_expected losers "
            "losers_expected");
    const struct range seeds = {1, sets}, cray = {64, 64};
    print_tally("uniform", "uniform", n / 8, seeds, cray);
    print_tally("uniform", "uniform", n * 8, seeds, cray);
    const char *const names[] = {"uniform", "clustered", "kuzmin",
                                 "two-clusters", "equal"};
    for (int d = 0; d < 5; d++)
        print_tally(names[d], names[d], n, seeds, (struct range){8, n});
    for (uint32_t seed = 1; seed <= SETS; seed++) {
        char name[40];
        sprintf(name, "clusters-set-%u", seed);
        print_tally(name, "clustered", n * 8,
                    (struct range){seed, seed}, cray);
    }
}
