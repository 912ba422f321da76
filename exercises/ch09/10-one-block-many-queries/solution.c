// The points of a block are copied to a buffer once, three spans of
// them, and all queries of the cell go through it in lanes. The rest of
// the last lanes is filled with what is never nearest.
#include "exercise.h"
#include <math.h>
#include <string.h>

//- solution
enum { LANES = 8, MOST = 9 * 64 + LANES };

struct buffer {
    uint32_t n, own; // how many, and where the cell's own begin
    double x[MOST], y[MOST];
};

static void fill(const struct sorted *sorted, uint32_t column,
                 uint32_t row, struct buffer *buffer)
{
    const uint32_t columns = sorted->columns;
    const uint32_t left = column > 0 ? column - 1 : 0;
    const uint32_t right = column + 1 < columns ? column + 1 : column;
    uint32_t n = 0;
    for (uint32_t r = row > 0 ? row - 1 : 0;
         r <= row + 1 && r < sorted->rows; r++) {
        const uint32_t *start = sorted->start + r * columns;
        const uint32_t begin = start[left];
        const uint32_t many = start[right + 1] - begin;
        memcpy(buffer->x + n, sorted->x + begin, many * sizeof(double));
        memcpy(buffer->y + n, sorted->y + begin, many * sizeof(double));
        if (r == row)
            buffer->own = n + start[column] - begin;
        n += many;
    }
    for (buffer->n = n; n % LANES != 0; n++)
        buffer->x[n] = buffer->y[n] = INFINITY;
}

// The query at place q of the buffer is out of its own way meanwhile.
static double search(struct buffer *buffer, uint32_t q)
{
    const double x = buffer->x[q], y = buffer->y[q];
    double best[LANES];
    for (int l = 0; l < LANES; l++)
        best[l] = INFINITY;
    buffer->x[q] = INFINITY;
    for (uint32_t c = 0; c < buffer->n; c += LANES)
        for (int l = 0; l < LANES; l++) {
            const double dx = buffer->x[c + l] - x;
            const double dy = buffer->y[c + l] - y;
            const double d2 = dx * dx + dy * dy;
            best[l] = d2 < best[l] ? d2 : best[l];
        }
    buffer->x[q] = x;
    for (int l = 1; l < LANES; l++)
        best[0] = best[l] < best[0] ? best[l] : best[0];
    return best[0];
}

//- starter
//- end
void nearest_in_block(const struct sorted *sorted, double *nearest2)
{
    //- solution
    struct buffer buffer;
    for (uint32_t row = 0; row < sorted->rows; row++)
        for (uint32_t column = 0; column < sorted->columns; column++) {
            const uint32_t *start =
                sorted->start + row * sorted->columns + column;
            if (start[0] == start[1])
                continue;
            fill(sorted, column, row, &buffer);
            for (uint32_t s = start[0]; s < start[1]; s++)
                nearest2[s] =
                    search(&buffer, buffer.own + s - start[0]);
        }
    //- starter
    // // Your turn: so far each point has only those of its own cell.
    // const uint32_t cells = sorted->columns * sorted->rows;
    // for (uint32_t k = 0; k < cells; k++)
    //     for (uint32_t s = sorted->start[k]; s < sorted->start[k + 1];
    //          s++) {
    //         nearest2[s] = INFINITY;
    //         for (uint32_t c = sorted->start[k];
    //              c < sorted->start[k + 1]; c++) {
    //             double dx = sorted->x[c] - sorted->x[s];
    //             double dy = sorted->y[c] - sorted->y[s];
    //             double d2 = dx * dx + dy * dy;
    //             if (c != s && d2 < nearest2[s])
    //                 nearest2[s] = d2;
    //         }
    //     }
    //- end
}
