// Points that the 3 by 3 block gets wrong, all of them: two pairs, each
// with a column between its points, side by side in two rows. The other
// pair is what each point finds in its block.
#include "exercise.h"

void fool_the_block(struct points points)
{
    //- solution
    // Four points in three columns and three rows, of which the last
    // stays empty, so that no other four come too near.
    const double x[] = {0.9, 2.1, 0.9, 2.1};
    const double y[] = {0.25, 0.25, 1.75, 1.75};
    for (uint32_t i = 0; i < points.n; i++) {
        uint32_t four = i / 4, per_row = COLUMNS / 3;
        points.x[i] = 3 * (four % per_row) + x[i % 4];
        points.y[i] = 3 * (four / per_row) + y[i % 4];
    }
    //- starter
    // // Your turn: this puts every point into a cell of its own, and
    // // fools none.
    // for (uint32_t i = 0; i < points.n; i++) {
    //     points.x[i] = i % COLUMNS + 0.5;
    //     points.y[i] = i / COLUMNS + 0.5;
    // }
    //- end
}
