// Points of two kinds, for each the rank of its furthest point, 0 for
// the one that is the furthest of most, and of how many it is the
// furthest itself.
//     regions [POINTS]
#include "common/experiment.h"

struct region {
    uint32_t point, points; // of so many it is the furthest
};

static int by_number(const void *a, const void *b)
{
    const struct region *p = a, *q = b;
    return (p->points < q->points) - (p->points > q->points);
}

static void print_kind(const char *kind, uint32_t n)
{
    struct question question = kind_question(kind, n, 1);
    struct answers *answers = new_answers(n, FURTHEST);
    find_algorithm("furthest-hull")->run(&question, answers);
    struct region *regions = take(n, sizeof *regions);
    uint32_t *rank = take(n, sizeof *rank);
    for (uint32_t i = 0; i < n; i++)
        regions[i].point = i;
    for (uint32_t i = 0; i < n; i++)
        regions[answers->furthest[i]].points++;
    qsort(regions, n, sizeof *regions, by_number);
    for (uint32_t k = 0; k < n; k++)
        rank[regions[k].point] = k;
    for (uint32_t i = 0; i < n; i++)
        row("%s\t%.5g\t%.5g\t%u\t%u", kind, question.points.x[i],
            question.points.y[i], rank[answers->furthest[i]],
            regions[rank[i]].points);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 6000, 2, MANY);
    print_header(&e, "kind x y rank points");
    print_kind("uniform", n);
    print_kind("clustered", n);
}
