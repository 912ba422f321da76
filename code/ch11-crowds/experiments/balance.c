// How even is the work of the leaves, and how well do threads share it?
// For points of every kind the distances of each leaf are counted; then
// the leaves are given out as the program gives them out, each to the
// thread that is free first, if every distance takes the same time. The
// share of the time in which threads work, for 2 to 64 of them. Last,
// the leaves of the disc of Kuzmin, one by one. Counts only.
//
//     balance [POINTS]
#include "ch11-crowds/piece_search.h"
#include "common/experiment.h"
#include "common/min_max.h"

enum { MOST_THREADS = 64, MOST_LEAVES = 1 << 14 };

struct leaf_work {
    uint32_t points, pieces;
    double distances;
};

// The search of a leaf alone, as if it were the only one.
static struct leaf_work work_of(const struct question *question,
                                const struct pieces *pieces, uint32_t k,
                                struct neighbor *results)
{
    struct counts counts = {0};
    struct question counted = *question;
    struct pieces one = *pieces;
    struct leaf_work work = {.pieces = pieces->count[k]};
    counted.counts = &counts;
    one.leaves = 1;
    one.first = &pieces->first[k];
    one.count = &pieces->count[k];
    search_pieces(&counted, &one, steps_allowed(question->points.n),
                  results);
    for (uint32_t i = 0; i < work.pieces; i++)
        work.points += pieces->piece[one.first[0] + i].sorted.points.n;
    work.distances = (double)counts.distances;
    return work;
}

static double efficiency(const struct leaf_work *work, uint32_t leaves,
                         int threads)
{
    double busy[MOST_THREADS] = {0}, sum = 0, longest = 0;
    for (uint32_t k = 0; k < leaves; k++) {
        int next = 0;
        for (int t = 1; t < threads; t++)
            next = busy[t] < busy[next] ? t : next;
        busy[next] += work[k].distances;
        sum += work[k].distances;
        longest = MAX(busy[next], longest);
    }
    return sum / (threads * longest);
}

static void print_kind(const char *kind, uint32_t n, bool leaves_too)
{
    static struct leaf_work work[MOST_LEAVES];
    const struct question question = kind_question(kind, n, 1);
    struct workspace workspace = {0};
    const struct pieces pieces = pieces_make(&question, &workspace);
    struct neighbor *results =
        workspace_take(&workspace, n, sizeof *results);
    struct leaf_work most = {0};
    for (uint32_t k = 0; k < pieces.leaves; k++) {
        work[k] = work_of(&question, &pieces, k, results);
        most.points = MAX(work[k].points, most.points);
        most.pieces = MAX(work[k].pieces, most.pieces);
        most.distances = MAX(work[k].distances, most.distances);
        if (leaves_too)
            row("leaf_%u\t%u\t1\t%u\t%u\t%.5g\t1\t1\t1\t1\t1\t1", k,
                work[k].points, work[k].points, work[k].pieces,
                work[k].distances);
    }
    if (!leaves_too) {
        row_begin("shared_%s\t%u\t%u\t%u\t%u\t%.5g", kind, n,
                  pieces.leaves, most.points, most.pieces,
                  most.distances);
        for (int t = 2; t <= MOST_THREADS; t *= 2)
            row_cells("\t%.4g", efficiency(work, pieces.leaves, t));
        row_end();
    }
    workspace_free(&workspace);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    columns(&e, "name n leaves points pieces distances two four eight "
                "sixteen thirty_two sixty_four");
    for (int d = 0; d < distribution_count; d++)
        print_kind(distributions[d].name, n, false);
    print_kind("kuzmin", n, true);
    return 0;
}
