// The pieces that points of every kind are cut into: how many, how deep
// the tree is, how many queries a batch could not certify, and how many
// distances a query was compared with; how many were predicted from the
// counts of the cells, and how many from the density of the points.
//
//     pieces [POINTS]
#include "ch11-crowds/experiments/cut_kinds.h"
#include "ch11-crowds/experiments/predict.h"
#include "common/experiment.h"

static uint32_t depth_of(const struct pieces *pieces, uint32_t k)
{
    const struct node *node = &pieces->node[k];
    if (node->first_child == 0)
        return 0;
    const uint32_t a = depth_of(pieces, node->first_child);
    const uint32_t b = depth_of(pieces, node->second_child);
    return 1 + (a > b ? a : b);
}

static void print_kind(const struct cut_kind *kind)
{
    const struct pieces *pieces = &kind->pieces;
    const uint32_t n = kind->question.points.n;
    struct counts counts = {0};
    struct question counted = kind->question;
    counted.counts = &counts;
    const uint32_t given_up = search_pieces(
        &counted, pieces, steps_allowed(n), kind->results);
    uint32_t count = 0;
    for (uint32_t k = 0; k < pieces->leaves; k++)
        count += pieces->count[k];
    row("cut_%s\t%u\t%u\t%.5g\t%u\t%.4g\t%u\t%.5g\t%.5g\t%.5g",
        kind->name, n, count, (double)n / count, depth_of(pieces, 0),
        (double)counts.exact / n, given_up,
        (double)counts.distances / n, predict_from_counts(pieces),
        predict_from_density(pieces, kind->name, 1));
}

int main(int argc, char **argv)
{
    cut_all_kinds(argc, argv,
                  "name n pieces points depth asked given_up distances "
                  "predicted from_density",
                  print_kind);
    return 0;
}
