// Points of two kinds, for each the rank of its furthest point, 0 for
// the one that is the furthest of most, and of how many it is the
// furthest itself.
//
//     fans [POINTS]
#include "algorithms.h"
#include "common/allocate.h"
#include "common/experiment.h"
#include <stdlib.h>

struct fan {
    uint32_t point, points; // furthest from so many
};

static int by_number(const void *a, const void *b)
{
    const struct fan *p = a, *q = b;
    return (p->points < q->points) - (p->points > q->points);
}

struct rank {
    uint32_t rank, points;
};

static struct rank *rank_points(const uint32_t *furthest, uint32_t n)
{
    struct fan *fans = allocate(n, sizeof *fans);
    struct rank *ranks = allocate(n, sizeof *ranks);
    for (uint32_t i = 0; i < n; i++)
        fans[i] = (struct fan){i, 0};
    for (uint32_t i = 0; i < n; i++)
        fans[furthest[i]].points++;
    qsort(fans, n, sizeof *fans, by_number);
    for (uint32_t k = 0; k < n; k++)
        ranks[fans[k].point] = (struct rank){k, fans[k].points};
    free(fans);
    return ranks;
}

static void print_kind(const char *kind, uint32_t n)
{
    struct question question = kind_question(kind, n, 1);
    struct answers answers = answers_for(n, FURTHEST);
    find_algorithm("furthest-hull")->run(&question, &answers);
    struct rank *ranks = rank_points(answers.furthest, n);
    for (uint32_t i = 0; i < n; i++)
        row("%s\t%.5g\t%.5g\t%u\t%u", kind, question.points.x[i],
            question.points.y[i], ranks[answers.furthest[i]].rank,
            ranks[i].points);
    free(ranks);
    answers_free(&answers);
    points_free(&question.points);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 6000, 2, MANY);
    columns(&e, "kind x y rank fans");
    print_kind("uniform", n);
    print_kind("clustered", n);
    return 0;
}
