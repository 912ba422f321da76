//> Capture triangles in motion
// Nodes move along straight lines, so all that a triangle sweeps over
// lies between its six corners, three at the beginning and three at the
// end: their box needs no other place. A triangle costs some 50
// operations.
#include "ch13-contact/boxes.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include <math.h>
#include <stdlib.h>

//> Keep room for boxes
void boxes_reserve(struct boxes *boxes, uint32_t n)
{
    if (n > boxes->room) {
        boxes_free(boxes);
        for (int k = 0; k < 3; k++) {
            boxes->low[k] = allocate(n, sizeof(double));
            boxes->high[k] = allocate(n, sizeof(double));
        }
        boxes->room = n;
    }
    boxes->n = n;
}

void boxes_free(struct boxes *boxes)
{
    for (int k = 0; k < 3; k++) {
        free(boxes->low[k]);
        free(boxes->high[k]);
    }
    *boxes = (struct boxes){0};
}
//<

//> Unite boxes
void boxes_unite(struct boxes *to, uint32_t i, const struct boxes *of,
                 uint32_t begin, uint32_t end)
{
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (uint32_t t = begin; t < end; t++) {
            low = MIN(low, of->low[k][t]);
            high = MAX(high, of->high[k][t]);
        }
        to->low[k][i] = low;
        to->high[k][i] = high;
    }
}
//<

//> Find the box of a step
struct interval {
    double low, high;
};

static struct interval interval_of(const struct scene *scene, int k,
                                   const uint32_t corner[3])
{
    const double *begin = scene->mesh.x[k], *end = scene->predicted[k];
    struct interval in = {INFINITY, -INFINITY};
    for (int c = 0; c < 3; c++) {
        const double a = begin[corner[c]], b = end[corner[c]];
        in.low = MIN(in.low, MIN(a, b));
        in.high = MAX(in.high, MAX(a, b));
    }
    return in;
}
//<

//> Add a margin that is enough
// Half of the tolerance, of the two boxes together all of it; where the
// widths w and v of the two set it, it is hardly more than 2^-40 of
// w + v, and 2^-29 of each is ample; and 2^-50 of the coordinates, for
// rounding takes away 2^-52 of them at most.
static double margin_of(const struct interval in[3], double tolerance)
{
    double width = 0, largest = 0;
    for (int k = 0; k < 3; k++) {
        width = MAX(width, in[k].high - in[k].low);
        largest = MAX(largest, MAX(fabs(in[k].low), fabs(in[k].high)));
    }
    return 0.5 * tolerance + 0x1p-29 * width + 0x1p-50 * largest;
}

void capture(struct boxes *boxes, const struct scene *scene,
             double tolerance, int threads)
{
    boxes_reserve(boxes, scene->mesh.triangles);
#pragma omp parallel for num_threads(threads) if (threads > 1)
    for (uint32_t t = 0; t < boxes->n; t++) {
        struct interval in[3];
        for (int k = 0; k < 3; k++)
            in[k] = interval_of(scene, k, scene->mesh.corner[t]);
        const double margin = margin_of(in, tolerance);
        for (int k = 0; k < 3; k++) {
            boxes->low[k][t] = in[k].low - margin;
            boxes->high[k][t] = in[k].high + margin;
        }
    }
}
//<
//<
