// Nine cells for each query, one after the other.
// expect: 4 of 10
#include "exercise.h"
#include <math.h>

void nearest_in_block(const struct sorted *sorted, double *nearest2)
{
    int columns = sorted->columns, rows = sorted->rows;
    for (int row = 0; row < rows; row++)
        for (int column = 0; column < columns; column++)
            for (uint32_t s = sorted->start[row * columns + column];
                 s < sorted->start[row * columns + column + 1]; s++) {
                nearest2[s] = INFINITY;
                for (int r = row - 1; r <= row + 1; r++)
                    for (int c = column - 1; c <= column + 1; c++) {
                        if (r < 0 || r >= rows || c < 0 || c >= columns)
                            continue;
                        int k = r * columns + c;
                        for (uint32_t j = sorted->start[k];
                             j < sorted->start[k + 1]; j++) {
                            double dx = sorted->x[j] - sorted->x[s];
                            double dy = sorted->y[j] - sorted->y[s];
                            double d2 = dx * dx + dy * dy;
                            if (j != s && d2 < nearest2[s])
                                nearest2[s] = d2;
                        }
                    }
            }
}
