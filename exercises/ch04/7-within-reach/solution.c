// All pairs closer than r, by cells that are at least that wide: those
// in one cell, and those of a cell and four of its eight neighbors.
#include "common/fail.h"
#include "exercise.h"
#include <stdlib.h>

//- solution
// A list of points for every cell.
struct lists {
    uint32_t columns, rows;
    uint32_t *first; // of every cell; n: none
    uint32_t *next;  // of every point
};

// Cells along an axis, a little wider than r, for the roundings. If
// both neighbors of a cell would be the same, there is one cell only.
static uint32_t count_cells(double length, double r, uint32_t most)
{
    double fit = length / r * (1 - 1e-12);
    uint32_t count = fit < most ? (uint32_t)fit : most;
    return count < 3 ? 1 : count;
}

static uint32_t cell_of(double x, double length, uint32_t count)
{
    uint32_t k = (uint32_t)(x / length * count);
    return k < count ? k : count - 1;
}

static struct lists make_lists(struct points points, struct space space,
                               double r)
{
    uint32_t columns = count_cells(space.width, r, points.n);
    uint32_t rows = count_cells(space.height, r, points.n / columns);
    size_t cells = (size_t)columns * rows;
    struct lists lists = {columns, rows,
                          allocate(cells, sizeof(uint32_t)),
                          allocate(points.n, sizeof(uint32_t))};
    for (size_t k = 0; k < cells; k++)
        lists.first[k] = points.n;
    for (uint32_t i = 0; i < points.n; i++) {
        uint32_t column = cell_of(points.x[i], space.width, columns);
        uint32_t row = cell_of(points.y[i], space.height, rows);
        lists.next[i] = lists.first[row * columns + column];
        lists.first[row * columns + column] = i;
    }
    return lists;
}

static void try(uint32_t i, uint32_t j, double r)
{
    if (measure(i, j) < r * r)
        take_pair(i, j);
}

// Each point of a cell with those behind it in the cell's own list, and
// with all of four neighbors: on the right, and the three above.
static void search_from(const struct lists *lists, uint32_t n,
                        uint32_t column, uint32_t row, double r)
{
    const uint32_t columns = lists->columns, rows = lists->rows;
    const int steps[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    uint32_t first = lists->first[row * columns + column];
    for (uint32_t i = first; i < n; i = lists->next[i])
        for (uint32_t j = lists->next[i]; j < n; j = lists->next[j])
            try(i, j, r);
    for (int s = 0; s < 4; s++) {
        if ((steps[s][0] != 0 && columns == 1) ||
            (steps[s][1] != 0 && rows == 1))
            continue;
        uint32_t c = (column + columns + steps[s][0]) % columns;
        uint32_t w = (row + steps[s][1]) % rows;
        for (uint32_t i = first; i < n; i = lists->next[i])
            for (uint32_t j = lists->first[w * columns + c]; j < n;
                 j = lists->next[j])
                try(i, j, r);
    }
}

//- starter
//- end
void pairs_within(struct points points, struct space space, double r)
{
    //- solution
    struct lists lists = make_lists(points, space, r);
    for (uint32_t row = 0; row < lists.rows; row++)
        for (uint32_t column = 0; column < lists.columns; column++)
            search_from(&lists, points.n, column, row, r);
    free(lists.first);
    free(lists.next);
    //- starter
    // // Your turn: this measures every pair, and takes too many.
    // for (uint32_t i = 0; i < points.n; i++)
    //     for (uint32_t j = i + 1; j < points.n; j++)
    //         if (measure(i, j) < r)
    //             take_pair(i, j);
    //- end
}
