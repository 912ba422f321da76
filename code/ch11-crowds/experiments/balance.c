// How even is the work of the leaves, and how well do threads share it?
// For points of every kind the distances of each leaf are counted; then
// the leaves are given out as the program gives them out, each to the
// thread that is free first, if every distance takes the same time. The
// share of the time in which threads work, for 2 to 64 of them. Last,
// the leaves of the disc of Kuzmin, one by one. Counts only.
//
//     balance [POINTS]
#include "ch11-crowds/experiments/cut_kinds.h"
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

// The work of all leaves, in the order in which threads get them.
static void measure_leaves(const struct cut_kind *kind,
                           struct leaf_work *work)
{
    for (uint32_t k = 0; k < kind->pieces.leaves; k++)
        work[k] =
            work_of(&kind->question, &kind->pieces, k, kind->results);
}

static void print_kind(const struct cut_kind *kind)
{
    static struct leaf_work work[MOST_LEAVES];
    const uint32_t leaves = kind->pieces.leaves;
    struct leaf_work most = {0};
    measure_leaves(kind, work);
    for (uint32_t k = 0; k < leaves; k++) {
        most.points = MAX(work[k].points, most.points);
        most.pieces = MAX(work[k].pieces, most.pieces);
        most.distances = MAX(work[k].distances, most.distances);
    }
    row_begin("shared_%s\t%u\t%u\t%u\t%u\t%.5g", kind->name,
              kind->question.points.n, leaves, most.points, most.pieces,
              most.distances);
    for (int t = 2; t <= MOST_THREADS; t *= 2)
        row_cells("\t%.4g", efficiency(work, leaves, t));
    row_end();
}

static void print_leaves(const struct cut_kind *kind)
{
    static struct leaf_work work[MOST_LEAVES];
    measure_leaves(kind, work);
    for (uint32_t k = 0; k < kind->pieces.leaves; k++)
        row("leaf_%u\t%u\t1\t%u\t%u\t%.5g\t1\t1\t1\t1\t1\t1", k,
            work[k].points, work[k].points, work[k].pieces,
            work[k].distances);
}

int main(int argc, char **argv)
{
    const uint32_t n = cut_all_kinds(
        argc, argv,
        "name n leaves points pieces distances two four eight sixteen "
        "thirty_two sixty_four",
        print_kind);
    cut_one_kind("kuzmin", n, print_leaves);
    return 0;
}
