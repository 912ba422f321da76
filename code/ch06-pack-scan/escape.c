//> Take steps until all have escaped
// The escape times of the Mandelbrot set, with one vector for all
// points, one lane for each. A step is elementwise and takes all lanes,
// useful or not; a packing keeps the lanes whose points have not
// escaped, for one pack and a gather for each array.
#include "ch06-pack-scan/escape.h"
#include "common/fail.h"
#include <stdlib.h>

//> Lay points over the plane
struct points picture(uint32_t width, uint32_t height)
{
    struct points c = points_allocate(width * height);
    for (uint32_t row = 0; row < height; row++)
        for (uint32_t column = 0; column < width; column++) {
            uint32_t i = row * width + column;
            c.x[i] = -2.2 + 3 * (column + 0.5) / width;
            c.y[i] = 1.125 - 2.25 * (row + 0.5) / height;
        }
    return c;
}
//<

//> Make room for lanes
// Large arrays, each allocated by itself, all begin at the same place
// of a page. Then a load from one could be taken for what has just been
// stored to another; so each begins eight lines further on in its page.
static size_t lanes_apart(uint32_t max)
{
    enum { PAGE = 4096 / sizeof(double), SHIFT = PAGE / 8 };
    return ((size_t)max + PAGE - 1) / PAGE * PAGE + SHIFT;
}

struct lanes lanes_allocate(uint32_t max)
{
    const size_t apart = lanes_apart(max);
    double *five = allocate(5 * apart, sizeof(double));
    struct lanes lanes = {
        .n = 0,
        .point = allocate(max, sizeof(uint32_t)),
        .cx = five,
        .cy = five + apart,
        .x = five + 2 * apart,
        .y = five + 3 * apart,
        .age = five + 4 * apart,
        .inside = allocate(max, sizeof(uint8_t)),
        .number = allocate(max, sizeof(uint32_t)),
        .kept = allocate(max, sizeof(uint32_t)),
    };
    for (uint32_t i = 0; i < max; i++)
        lanes.number[i] = i;
    return lanes;
}

void lanes_free(struct lanes *lanes)
{
    free(lanes->point);
    free(lanes->cx); // with the four others
    free(lanes->inside);
    free(lanes->number);
    free(lanes->kept);
    *lanes = (struct lanes){0};
}
//<

//> Give every point a lane
static void begin(struct lanes *lanes, struct points c)
{
    lanes->n = c.n;
    for (uint32_t i = 0; i < c.n; i++) {
        lanes->point[i] = i;
        lanes->cx[i] = c.x[i];
        lanes->cy[i] = c.y[i];
        lanes->x[i] = lanes->y[i] = lanes->age[i] = 0;
    }
}
//<

//> Take a step in every lane
static void step(struct lanes *lanes)
{
    const double *cx = lanes->cx, *cy = lanes->cy;
    double *x = lanes->x, *y = lanes->y, *age = lanes->age;
    const uint32_t n = lanes->n;
#pragma omp simd
    for (uint32_t i = 0; i < n; i++) {
        double xx = x[i] * x[i], yy = y[i] * y[i], xy = x[i] * y[i];
        x[i] = xx - yy + cx[i];
        y[i] = xy + xy + cy[i];
        age[i] += xx + yy <= 16 ? 1 : 0;
    }
}
//<

//> Mark the lanes that go on
static void mark(struct lanes *lanes)
{
    const double *x = lanes->x, *y = lanes->y;
    uint8_t *inside = lanes->inside;
    const uint32_t n = lanes->n;
#pragma omp simd
    for (uint32_t i = 0; i < n; i++)
        inside[i] = x[i] * x[i] + y[i] * y[i] <= 16;
}
//<

//> Pack the lanes
// All gathers are in place: kept[i] >= i.
static void pack_lanes(const struct primitives *p, struct lanes *l)
{
    mark(l);
    l->n = p->pack(l->kept, l->number, l->inside, l->n);
    p->gather32(l->point, l->point, l->kept, l->n);
    p->gather(l->cx, l->cx, l->kept, l->n);
    p->gather(l->cy, l->cy, l->kept, l->n);
    p->gather(l->x, l->x, l->kept, l->n);
    p->gather(l->y, l->y, l->kept, l->n);
    p->gather(l->age, l->age, l->kept, l->n);
}
//<

//> Step, note the ages, pack
uint64_t escape(const struct primitives *p, struct points c,
                uint32_t limit, uint32_t every, struct lanes *lanes,
                double *steps)
{
    uint64_t done = 0;
    begin(lanes, c);
    for (uint32_t k = 1; k <= limit && lanes->n > 0; k++) {
        step(lanes);
        done += lanes->n;
        if (k == limit || (every && k % every == 0)) {
            p->scatter(steps, lanes->age, lanes->point, lanes->n);
            pack_lanes(p, lanes);
        }
    }
    return done;
}
//<
//<
