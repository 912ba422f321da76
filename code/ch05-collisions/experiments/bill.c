// Counts points in random cells, so few that counts and tickets fit
// into the first cache, and fits a line: so much for a point, so much
// for a loser. (The largest number of cells fills that cache, and is
// left out of the line.) Then counts points of all kinds in their own
// cells, plainly, by groups and by detecting conflicts, beside what the
// line predicts.
//     bill [POINTS [TRIALS]]
#include "ch05-collisions/conflict.h"
#include "ch05-collisions/groups.h"
#include "common/experiment.h"

enum { PLAINLY, BY_GROUPS, BY_CONFLICTS, WAYS };
enum { FEWEST_CELLS = 16, SIZES = 9, LENGTHS = 3, LANES = 64 };
enum { KINDS = 5, ROWS = LENGTHS * SIZES + KINDS };

static const char *const kinds[KINDS] = {
    "uniform", "clustered", "two-clusters", "kuzmin", "equal"};

// A line of the table, and what is needed to time it.
struct row {
    char name[40];
    struct groups groups;
    uint32_t n, cells, *cell_id, *count;
    uint64_t losers;
    struct summary summaries[WAYS];
};

static void plainly(void *context)
{
    struct row *row = context;
    for (uint32_t i = 0; i < row->n; i++)
        row->count[row->cell_id[i]]++;
}

static void by_groups(void *context)
{
    struct row *row = context;
    row->losers =
        groups_count(&row->groups, row->cell_id, row->n, row->count);
}

static void by_conflicts(void *context)
{
    struct row *row = context;
    conflict_count(row->cell_id, row->n, row->count);
}

static void time_rows(struct row *rows, int trials)
{
    static void (*const works[WAYS])(void *) = {plainly, by_groups,
                                                by_conflicts};
    struct trial versions[ROWS * WAYS];
    for (int v = 0; v < ROWS * WAYS; v++)
        versions[v] = (struct trial){.work = works[v % WAYS],
                                     .context = &rows[v / WAYS]};
    time_in_turn(trials, versions, ROWS * WAYS);
    for (int v = 0; v < ROWS * WAYS; v++)
        rows[v / WAYS].summaries[v % WAYS] = versions[v].summary;
}

// Its points' cell ids are not yet set.
static struct row new_row(uint32_t n, uint32_t cells, uint32_t lanes)
{
    return (struct row){.n = n,
                        .cells = cells,
                        .groups = groups_allocate(lanes, cells),
                        .cell_id = take(n, sizeof(uint32_t)),
                        .count = take(cells, sizeof(uint32_t))};
}

static struct row random_row(uint32_t n, uint32_t cells, uint32_t lanes)
{
    struct random random = {1};
    struct row row = new_row(n, cells, lanes);
    for (uint32_t i = 0; i < n; i++)
        row.cell_id[i] = random_bits(&random) % cells;
    sprintf(row.name, "random_%u_%u", cells, lanes);
    return row;
}

static struct row points_row(uint32_t n, const char *kind)
{
    struct question question = kind_question(kind, n, 1);
    struct grid grid = grid_fit(&question, 2);
    struct row row = new_row(n, grid_cells(&grid), LANES);
    find_cell_ids(&grid, question.points, 0, n, row.cell_id);
    sprintf(row.name, "%s_points", kind);
    return row;
}

struct line {
    double point, loser; // nanoseconds
};

static struct line fit(const struct row *rows, int count)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    for (int row = 0; row < count; row++) {
        double n = rows[row].n, losers = rows[row].losers / n;
        double ns = rows[row].summaries[BY_GROUPS].median / n;
        x += losers, xx += losers * losers;
        y += ns, xy += losers * ns;
    }
    double slope = (count * xy - x * y) / (count * xx - x * x);
    return (struct line){(y - slope * x) / count, slope};
}

// The last column says whether conflicts were detected by instruction.
static void print_row(const struct row *row, struct line line)
{
    double losers = (double)row->losers / row->n;
    row_begin("%s\t%u\t%u\t%.4g\t%.4g", row->name, row->cells,
              row->groups.lanes, losers,
              line.point + line.loser * losers);
    for (int way = 0; way < WAYS; way++)
        row_times(&row->summaries[way], row->n);
    row_cells("\t%s",
              isa_names[isa_chosen() == AVX512 ? AVX512 : PORTABLE]);
    row_end();
}

// What the line says of one point, or one loser; it was not timed.
static void print_price(const char *name, int losers, double ns)
{
    row("%s\tnan\t%d\t%d\t%.4g\tnan\tnan\tnan\tnan\tnan\tnan\tnan\tnan"
        "\tnan\tnone",
        name, LANES, losers, ns);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 200000, 1000, MANY / 10);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct row rows[ROWS], *row = rows;
    static const uint32_t lanes[LENGTHS] = {LANES, LANES / 8,
                                            LANES * 8};
    for (int length = 0; length < LENGTHS; length++)
        for (int size = 0; size < SIZES; size++)
            *row++ = random_row(n, FEWEST_CELLS << size, lanes[length]);
    for (int kind = 0; kind < KINDS; kind++)
        *row++ = points_row(n, kinds[kind]);
    time_rows(rows, trials);
    struct line line = fit(rows, SIZES - 1); // 64 lanes, 2,048 cells
    print_header(&e,
                 "name cells lanes losers predicted plain:3 groups:3 "
                 "conflicts:3 instructions");
    print_price("point", 0, line.point);
    print_price("loser", 1, line.loser);
    for (int r = 0; r < ROWS; r++)
        print_row(&rows[r], line);
}
