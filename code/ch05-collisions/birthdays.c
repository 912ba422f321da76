//> Count collisions against the law of birthdays
// For groups of 8, 16, 32, ... lanes and all kinds of points: how many
// pairs of lanes collide and how many lanes lose, beside what is to be
// expected if the points come in random order. On average over several
// sets of points.
//
//     birthdays [POINTS [SETS]]
#include "ch05-collisions/groups.h"
#include "ch05-collisions/home.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/report.h"
#include <stdlib.h>
#include <string.h>

struct tally {
    double cells, others, pairs, losers;
    double pairs_expected, losers_expected;
};

//> Count the pairs that collide
// count is all zeros before and after.
static double pairs_of(const uint32_t *home, uint32_t n, uint32_t lanes,
                       uint32_t *count)
{
    double pairs = 0;
    for (uint32_t begin = 0; begin < n; begin += lanes) {
        uint32_t end = n - begin < lanes ? n : begin + lanes;
        for (uint32_t i = begin; i < end; i++)
            pairs += count[home[i]]++;
        for (uint32_t i = begin; i < end; i++)
            count[home[i]] = 0;
    }
    return pairs;
}
//<

//> Expect losers in a cell
// A group is lanes of the n points, drawn without putting back; k
// points are in this cell. All of them lose but one for each group in
// which there is somebody.
static double losers_expected(double n, double k, double lanes)
{
    double nobody = 1;
    for (double j = 0; j < k && nobody > 0; j++)
        nobody *= fmax(0, 1 - lanes / (n - j));
    return k - n / lanes * (1 - nobody);
}
//<

//> Tally one set of points
static void add_set(struct tally *tally, const uint32_t *home,
                    uint32_t n, uint32_t m, uint32_t lanes,
                    uint32_t *count)
{
    struct groups groups = groups_allocate(lanes, m);
    tally->pairs += pairs_of(home, n, lanes, count);
    tally->losers += groups_count(&groups, home, n, count);
    double others = 0;
    for (uint32_t cell = 0; cell < m; cell++) {
        double k = count[cell];
        others += k * (k - 1) / n;
        tally->losers_expected += losers_expected(n, k, lanes);
        count[cell] = 0;
    }
    tally->others += others;
    tally->pairs_expected += others * (lanes - 1) / 2;
    tally->cells += m;
    groups_free(&groups);
}
//<

//> Tally several sets and print their means
static void print_tally(const char *distribution, uint32_t n, int sets,
                        uint32_t first_lanes, uint32_t last_lanes)
{
    struct tally tallies[32] = {0};
    for (int set = 0; set < sets; set++) {
        struct points points =
            generate(find_distribution(distribution), n, set + 1);
        struct question question = {points, {STANDARD, 1, 1}, 1};
        struct grid grid = grid_fit(&question, 2);
        const uint32_t m = grid_cells(&grid);
        uint32_t *home = allocate(n, sizeof *home);
        uint32_t *count = allocate(m, sizeof *count);
        memset(count, 0, m * sizeof *count);
        find_homes(&grid, points, 0, n, home);
        int row = 0;
        for (uint32_t l = first_lanes; l <= last_lanes; l *= 2)
            add_set(&tallies[row++], home, n, m, l, count);
        free(count);
        free(home);
        grid_free(&grid);
        points_free(&points);
    }
    int row = 0;
    for (uint32_t l = first_lanes; l <= last_lanes; l *= 2) {
        const struct tally *t = &tallies[row++];
        print_word(stdout, distribution);
        printf("_%u_%u\t%u\t%.0f\t%u\t%.4g\t%.6g\t%.6g\t%.6g\t%.6g\n",
               l, n, n, t->cells / sets, l, t->others / sets,
               t->pairs / sets, t->pairs_expected / sets,
               t->losers / sets, t->losers_expected / sets);
    }
}
//<

int main(int argc, char **argv)
{
    fail_as("birthdays");
    uint32_t n =
        argument(argc, argv, 1, "POINTS", 1 << 14, 1 << 10, 1 << 25);
    int sets = argument(argc, argv, 2, "SETS", 10, 1, MANY);
    while (n & (n - 1))
        n &= n - 1; // a power of two, so that all groups are full
    report_provenance(stdout);
    puts("name\tn\tcells\tlanes\tothers\tpairs\tpairs_expected"
         "\tlosers\tlosers_expected");
    print_tally("uniform", n / 8, sets, 64, 64);
    print_tally("uniform", n * 8, sets, 64, 64);
    const char *const names[] = {"uniform", "clustered", "kuzmin",
                                 "two-clusters", "equal"};
    for (int d = 0; d < 5; d++)
        print_tally(names[d], n, sets, 8, n);
    return 0;
}
//<
