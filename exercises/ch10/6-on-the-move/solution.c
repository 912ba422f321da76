// A point may stray from its cell by a margin before it is put into
// another. The border of a block is trusted by so much less.
#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

//- solution
static const double margin = 0.125;

static bool has_strayed(double x, uint32_t k)
{
    return x < k - margin || x > k + 1 + margin;
}

// How far it is from x, in column or row k of so many, to the nearer
// border of those within reach, if there is anything beyond.
static double border(double x, uint32_t k, uint32_t many,
                     uint32_t reach)
{
    double low = k > reach ? x - (k - reach) : INFINITY;
    double high = k + reach + 1 < many ? k + reach + 1 - x : INFINITY;
    return fmin(low, high);
}

struct best {
    uint32_t nearest;
    double d2;
};

static struct best search_cell(struct points points, uint32_t i,
                               uint32_t cell, struct best best)
{
    for (uint32_t j = first_in(cell); j != NONE; j = next_to(j)) {
        if (j == i)
            continue;
        double d2 = measure(points, i, j);
        if (d2 < best.d2 || (d2 == best.d2 && j < best.nearest))
            best = (struct best){j, d2};
    }
    return best;
}

// The cells whose row or column is exactly so far away.
static struct best search_ring(struct points points, struct box box,
                               uint32_t i, int reach, struct best best)
{
    int column = points.x[i], row = points.y[i];
    for (int r = row - reach; r <= row + reach; r++) {
        bool whole = abs(r - row) == reach;
        for (int c = column - reach; c <= column + reach;
             c += whole ? 1 : 2 * reach)
            if (r >= 0 && r < (int)box.rows && c >= 0 &&
                c < (int)box.columns)
                best =
                    search_cell(points, i, r * box.columns + c, best);
    }
    return best;
}

//- starter
//- end
void keep_up(struct points points, struct box box)
{
    //- solution
    for (uint32_t i = 0; i < points.n; i++) {
        double x = points.x[i], y = points.y[i];
        uint32_t cell = kept_in(i);
        if (cell == NONE || has_strayed(x, cell % box.columns) ||
            has_strayed(y, cell / box.columns))
            put(i, (uint32_t)y * box.columns + (uint32_t)x);
    }
    //- starter
    // // Your turn: all points are put anew, at every step.
    // for (uint32_t i = 0; i < points.n; i++)
    //     put(i, (uint32_t)points.y[i] * box.columns +
    //                (uint32_t)points.x[i]);
    //- end
}

uint32_t nearest_now(struct points points, struct box box, uint32_t i)
{
    //- solution
    double x = points.x[i], y = points.y[i];
    struct best best = {NONE, INFINITY};
    for (uint32_t reach = 0;; reach++) {
        best = search_ring(points, box, i, reach, best);
        double certain = fmin(border(x, x, box.columns, reach),
                              border(y, y, box.rows, reach)) -
                         margin;
        if (certain > 0 && best.d2 < certain * certain)
            return best.nearest;
    }
    //- starter
    // // Your turn: this looks no further than the cell of the point.
    // uint32_t nearest = NONE;
    // double nearest2 = INFINITY;
    // for (uint32_t j = first_in(kept_in(i)); j != NONE; j =
    // next_to(j))
    //     if (measure(points, i, j) < nearest2) {
    //         nearest = j;
    //         nearest2 = measure(points, i, j);
    //     }
    // return nearest;
    //- end
}
