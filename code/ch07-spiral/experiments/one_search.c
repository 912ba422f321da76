// Runs one search of the table once, on uniform points, so that another
// program can count what the processor does in it.
//
//     one_search blocks|together|spiral [POINTS]
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/point_by_point.h"
#include "ch07-spiral/spiral.h"
#include "common/experiment.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const char *name = argc > 1 ? argv[e.next++] : "spiral";
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    search_function *search =
        strcmp(name, "blocks") == 0     ? cells_indices
        : strcmp(name, "together") == 0 ? cells_batched
                                        : spiral;
    search(&question, new_answers(n, BOTH));
    return 0;
}
