//> Add up tallies
// Field by field, once for each thread at the end of a search.
#include "ch08-vector-spiral/tally.h"

void tally_add(struct tally *sum, const struct tally *tally)
{
    sum->tasks += tally->tasks;
    for (int k = 0; k < LAYERS_TALLIED; k++) {
        sum->phase_one[k] += tally->phase_one[k];
        sum->phase_two[k] += tally->phase_two[k];
        sum->of_layer[k] += tally->of_layer[k];
    }
    sum->listed += tally->listed;
    sum->bound_steps += tally->bound_steps;
    sum->tried += tally->tried;
    sum->visited += tally->visited;
    sum->entered += tally->entered;
    sum->compared += tally->compared;
    sum->cell_steps += tally->cell_steps;
    sum->point_steps += tally->point_steps;
    sum->lanes += tally->lanes;
    sum->lanes_unpacked += tally->lanes_unpacked;
}
//<
