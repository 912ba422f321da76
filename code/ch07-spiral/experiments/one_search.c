// Run one search of the table once, on uniform points, so that another
// program can count what the processor does in it.
//
//     one_search blocks|together|spiral [POINTS]
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/point_by_point.h"
#include "ch07-spiral/spiral.h"
#include "common/experiment.h"
#include <string.h>

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const char *name = argc > 1 ? argv[e.next++] : "spiral";
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers answers = answers_allocate(n);
    if (strcmp(name, "blocks") == 0)
        cells_indices(&question, &answers);
    else if (strcmp(name, "together") == 0)
        cells_batched(&question, &answers);
    else
        spiral(&question, &answers);
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
