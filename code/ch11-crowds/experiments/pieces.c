// The pieces that points of every kind are cut into: how many, how deep
// the tree is, how many queries a batch could not certify, and how many
// distances were predicted from the cells' counts, and measured.
//
//     pieces [POINTS]
#include "algorithms.h"
#include "ch11-crowds/ask_pieces.h"
#include "ch11-crowds/piece_search.h"
#include "common/experiment.h"
#include "common/generate.h"

static uint32_t depth_of(const struct pieces *pieces, uint32_t k)
{
    const struct node *node = &pieces->node[k];
    if (node->child == 0)
        return 0;
    const uint32_t a = depth_of(pieces, node->child);
    const uint32_t b = depth_of(pieces, node->sibling);
    return 1 + (a > b ? a : b);
}

// 22 + 9 c for c points in a cell (chapter 9), where c is what the cell
// of a point holds besides it, on average; 1 for points in one place.
static double squares_of(const struct piece *piece)
{
    const uint32_t *start = piece->sorted.cells.start;
    double sum = 0;
    for (uint32_t k = 0; k < grid_cells(&piece->sorted.grid); k++) {
        const double count = start[k + 1] - start[k];
        sum += count * (22 + 9 * (count - 1));
    }
    return sum;
}

static double predict(const struct pieces *pieces)
{
    double sum = 0;
    for (uint32_t k = 0; k < pieces->leaves; k++)
        for (uint32_t i = 0; i < pieces->count[k]; i++) {
            const struct piece *piece =
                &pieces->piece[pieces->first[k] + i];
            sum += piece->is_place ? piece->sorted.points.n
                                   : squares_of(piece);
        }
    return sum / pieces->sorted.points.n;
}

static void print_kind(const char *kind, uint32_t n)
{
    struct question question = kind_question(kind, n, 1);
    struct workspace workspace = {0};
    const struct pieces pieces = pieces_make(&question, &workspace);
    struct counts counts = {0};
    question.counts = &counts;
    struct neighbor *results =
        workspace_take(&workspace, n, sizeof *results);
    const uint32_t given_up =
        search_pieces(&question, &pieces, steps_allowed(n), results);
    uint32_t count = 0;
    for (uint32_t k = 0; k < pieces.leaves; k++)
        count += pieces.count[k];
    row("cut_%s\t%u\t%u\t%.5g\t%u\t%.4g\t%u\t%.5g\t%.5g", kind, n,
        count, (double)n / count, depth_of(&pieces, 0),
        (double)counts.tasks / n, given_up,
        (double)counts.distances / n, predict(&pieces));
    workspace_free(&workspace);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    columns(&e, "name n pieces points depth asked given_up distances "
                "predicted");
    for (int d = 0; d < distribution_count; d++)
        print_kind(distributions[d].name, n);
    return 0;
}
