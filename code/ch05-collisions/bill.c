//> Write the bill of counting by groups
//     bill [POINTS [TRIALS]]
// Counts points in random cells, so few that all counts fit into the
// first cache, and fits a line: so much for a point, so much for a
// loser. Then counts points of all kinds in their own cells, plainly,
// by groups and by detecting conflicts, beside what the line predicts.
#include "ch02-all-pairs/timing.h"
#include "ch05-collisions/conflict.h"
#include "ch05-collisions/groups.h"
#include "ch05-collisions/home.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/isa.h"
#include "common/random.h"
#include "common/report.h"
#include <stdlib.h>
#include <string.h>

enum { PLAINLY, BY_GROUPS, BY_CONFLICTS, WAYS };
enum { FEWEST_CELLS = 16, SIZES = 9, LANES = 64, KINDS = 5 };

struct row {
    char name[40];
    uint32_t cells, lanes;
    double losers; // a point
    struct trial trials[WAYS];
};

//> Count in three ways
struct counting {
    struct groups groups;
    const uint32_t *home;
    uint32_t n, *count;
    uint64_t losers;
};

static void plainly(void *context)
{
    struct counting *c = context;
    for (uint32_t i = 0; i < c->n; i++)
        c->count[c->home[i]]++;
}

static void by_groups(void *context)
{
    struct counting *c = context;
    c->losers = groups_count(&c->groups, c->home, c->n, c->count);
}

static void by_conflicts(void *context)
{
    struct counting *c = context;
    conflict_count(c->home, c->n, c->count);
}
//<

//> Time three ways to count
static struct row time_row(const uint32_t *home, uint32_t n,
                           uint32_t cells, uint32_t lanes, int trials)
{
    struct counting c = {groups_allocate(lanes, cells), home, n,
                         allocate(cells, sizeof(uint32_t)), 0};
    memset(c.count, 0, cells * sizeof *c.count);
    struct row row = {
        .cells = cells,
        .lanes = lanes,
        .trials = {{.work = plainly, .context = &c},
                   {.work = by_groups, .context = &c},
                   {.work = by_conflicts, .context = &c}}};
    time_in_turn(trials, row.trials, WAYS);
    row.losers = (double)c.losers / n;
    free(c.count);
    groups_free(&c.groups);
    return row;
}
//<

//> Count in few random cells
static void time_random_cells(struct row *rows, uint32_t n,
                              uint32_t lanes, int trials)
{
    struct random random = {1};
    uint32_t *home = allocate(n, sizeof *home);
    for (int size = 0; size < SIZES; size++) {
        uint32_t cells = FEWEST_CELLS << size;
        for (uint32_t i = 0; i < n; i++)
            home[i] = random_bits(&random) % cells;
        rows[size] = time_row(home, n, cells, lanes, trials);
        snprintf(rows[size].name, sizeof rows->name, "random_%u_%u",
                 cells, lanes);
    }
    free(home);
}
//<

//> Count points of all kinds
static void time_points(struct row *rows, uint32_t n, int trials)
{
    static const char *const kinds[KINDS][2] = {
        {"uniform", "uniform_points"},
        {"clustered", "clustered_points"},
        {"kuzmin", "kuzmin_points"},
        {"two-clusters", "two_clusters_points"},
        {"equal", "equal_points"}};
    uint32_t *home = allocate(n, sizeof *home);
    for (int kind = 0; kind < KINDS; kind++) {
        struct points points =
            generate(find_distribution(kinds[kind][0]), n, 1);
        struct question question = {points, {STANDARD, 1, 1}, 1};
        struct grid grid = grid_fit(&question, 2);
        find_homes(&grid, points, 0, n, home);
        rows[kind] =
            time_row(home, n, grid_cells(&grid), LANES, trials);
        strcpy(rows[kind].name, kinds[kind][1]);
        grid_free(&grid);
        points_free(&points);
    }
    free(home);
}
//<

//> Fit a line by least squares
struct line {
    double point, loser; // nanoseconds
};

static struct line fit(const struct row *rows, int count, double n)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    for (int row = 0; row < count; row++) {
        double losers = rows[row].losers;
        double ns = rows[row].trials[BY_GROUPS].summary.median / n;
        x += losers, xx += losers * losers;
        y += ns, xy += losers * ns;
    }
    double slope = (count * xy - x * y) / (count * xx - x * x);
    return (struct line){(y - slope * x) / count, slope};
}
//<

//> Print the bill and what it predicts
// The last column says whether conflicts were detected by instruction.
static void print_rows(const struct row *rows, int count, double n,
                       struct line line)
{
    for (int r = 0; r < count; r++) {
        const struct row *row = &rows[r];
        printf("%s\t%u\t%u\t%.4g\t%.4g", row->name, row->cells,
               row->lanes, row->losers,
               line.point + line.loser * row->losers);
        for (int way = 0; way < WAYS; way++)
            print_summary(&row->trials[way].summary, n);
        printf("\t%s\n",
               isa_names[isa_chosen() == AVX512 ? AVX512 : PORTABLE]);
    }
}
//<

int main(int argc, char **argv)
{
    fail_as("bill", NULL);
    uint32_t n =
        argument(argc, argv, 1, "POINTS", 200000, 1000, MANY / 10);
    int trials = argument(argc, argv, 2, "TRIALS", 5, 1, MANY);
    struct row few[SIZES], shorter[SIZES], longer[SIZES], all[KINDS];
    time_random_cells(few, n, LANES, trials);
    time_random_cells(shorter, n, LANES / 8, trials);
    time_random_cells(longer, n, LANES * 8, trials);
    time_points(all, n, trials);
    struct line line = fit(few, SIZES, n);
    report_provenance(stdout);
    puts("name\tcells\tlanes\tlosers\tpredicted"
         "\tplain\tplain_q1\tplain_q3\tgroups\tgroups_q1\tgroups_q3"
         "\tconflicts\tconflicts_q1\tconflicts_q3\tinstructions");
    printf("point\t0\t%d\t0\t%.4g\n", LANES, line.point);
    printf("loser\t0\t%d\t1\t%.4g\n", LANES, line.loser);
    print_rows(few, SIZES, n, line);
    print_rows(shorter, SIZES, n, line);
    print_rows(longer, SIZES, n, line);
    print_rows(all, KINDS, n, line);
    return 0;
}
//<
