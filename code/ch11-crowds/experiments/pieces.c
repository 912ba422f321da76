// The pieces that points of every kind are cut into: how many, how deep
// the tree is, how many queries a batch could not certify, and how many
// distances a query was compared with; how many were predicted from the
// counts of the cells, and how many from the density of the points.
//
//     pieces [POINTS]
#include "ch11-crowds/experiments/predict.h"
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
    row("cut_%s\t%u\t%u\t%.5g\t%u\t%.4g\t%u\t%.5g\t%.5g\t%.5g", kind, n,
        count, (double)n / count, depth_of(&pieces, 0),
        (double)counts.tasks / n, given_up,
        (double)counts.distances / n, predict_from_counts(&pieces),
        predict_from_density(&pieces, kind, 1));
    workspace_free(&workspace);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    columns(&e, "name n pieces points depth asked given_up distances "
                "predicted from_density");
    for (int d = 0; d < distribution_count; d++)
        print_kind(distributions[d].name, n);
    return 0;
}
