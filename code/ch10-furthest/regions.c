//> Cut the box into regions
// See regions.h. Here coordinates are measured from the box's lower
// left, so that they are as exact as the box is large. Whether a is
// further than b is decided by |q - a|^2 - |q - b|^2, which changes
// evenly with q: in a square it is least in one of the four corners of
// the square. Squared distances, computed here or there, err by less
// than 2^-50 of that of the box's diagonal, so 2^-46 is a safe margin.
#include "ch10-furthest/regions.h"
#include "ch05-collisions/home.h"
#include "common/count.h"
#include "common/fail.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

// What is known while the regions are made.
struct making {
    struct points points; // the corners, from the lower left
    double width, height; // of the box
    double margin;        // in squared distances
    size_t enough;        // entries in all lists
    struct regions *regions;
};

// Regions left .. left + side - 1 in rows bottom and so on.
struct square {
    uint32_t left, bottom, side;
};

//> Keep who can be the furthest in a square
// Of the corners from[0 .. count-1], all but those that are nearer, to
// everybody in the square, than the one furthest from its middle.
// The square is taken a little larger than it is, for rounding.
static uint32_t keep_far(const struct making *making,
                         struct square square, const uint32_t *from,
                         uint32_t count, uint32_t *to)
{
    const struct points p = making->points;
    const double width = making->width / making->regions->side;
    const double height = making->height / making->regions->side;
    const double x = (square.left + 0.5 * square.side) * width;
    const double y = (square.bottom + 0.5 * square.side) * height;
    const double right = 0.5 * square.side * width * (1 + 0x1p-20);
    const double up = 0.5 * square.side * height * (1 + 0x1p-20);
    double most2 = -1;
    uint32_t far = 0, kept = 0;
    for (uint32_t k = 0; k < count; k++) {
        double d2 = distance2(p.x[from[k]] - x, p.y[from[k]] - y);
        if (d2 > most2)
            most2 = d2, far = from[k];
    }
    for (uint32_t k = 0; k < count; k++) {
        uint32_t b = from[k];
        double d2 = distance2(p.x[b] - x, p.y[b] - y);
        double change = 2 * (fabs(p.x[far] - p.x[b]) * right +
                             fabs(p.y[far] - p.y[b]) * up);
        if (!(most2 - d2 > change + making->margin))
            to[kept++] = b;
    }
    return kept;
}
//<

//> Give a square its list
// All its regions share it.
static uint32_t add_list(struct regions *regions, const uint32_t *list,
                         uint32_t count)
{
    size_t needed = regions->length + count + 1;
    if (needed > regions->room) {
        uint32_t *old = regions->list;
        regions->room = 2 * needed;
        regions->list = allocate(regions->room, sizeof *old);
        if (old)
            memcpy(regions->list, old, regions->length * sizeof *old);
        free(old);
    }
    uint32_t *entry = regions->list + regions->length;
    entry[0] = count;
    memcpy(entry + 1, list, count * sizeof *list);
    uint32_t begin = regions->length;
    regions->length = needed;
    return begin;
}

static void give_list(struct regions *regions, struct square square,
                      const uint32_t *list, uint32_t count)
{
    uint32_t entry =
        count == 1 ? list[0]
                   : regions->corners + add_list(regions, list, count);
    for (uint32_t row = 0; row < square.side; row++) {
        uint32_t *region =
            regions->region +
            (size_t)(square.bottom + row) * regions->side + square.left;
        for (uint32_t column = 0; column < square.side; column++)
            region[column] = entry;
    }
}
//<

//> Divide a square
// Into four, until one corner is left, or it is a region, or the lists
// get too long. to has room for all lists that this one comes from.
static void divide(const struct making *making, struct square square,
                   const uint32_t *from, uint32_t count, uint32_t *to)
{
    uint32_t kept = keep_far(making, square, from, count, to);
    if (kept == 1 || square.side == 1 ||
        making->regions->length > making->enough) {
        give_list(making->regions, square, to, kept);
        return;
    }
    uint32_t half = square.side / 2;
    for (int quarter = 0; quarter < 4; quarter++) {
        struct square part = {square.left + quarter % 2 * half,
                              square.bottom + quarter / 2 * half, half};
        divide(making, part, to, kept, to + kept);
    }
}
//<

//> Choose how many regions
// Eight to thirty-two points to a region, but no more regions
// than lists of all corners in one row of them have room for.
enum { POINTS_PER_REGION = 8, MOST_LISTED = 1 << 24 };

static uint32_t side_for(uint32_t n, uint32_t corners)
{
    double most = (double)MOST_LISTED / corners;
    uint32_t side = 1;
    while (4.0 * side * side <= (double)n / POINTS_PER_REGION &&
           2.0 * side <= most)
        side *= 2;
    return side;
}
//<

//> Find the box of the corners
static void find_box(struct points p, double *left, double *right,
                     double *bottom, double *top)
{
    *left = *right = p.x[0];
    *bottom = *top = p.y[0];
    for (uint32_t k = 1; k < p.n; k++) {
        *left = fmin(*left, p.x[k]);
        *right = fmax(*right, p.x[k]);
        *bottom = fmin(*bottom, p.y[k]);
        *top = fmax(*top, p.y[k]);
    }
}
//<

//> Make the regions
static double regions_per(uint32_t side, double length)
{
    double per = side / length;
    return isfinite(per) ? per : 0; // 0 * 0 is in the first
}

static void make_lists(struct making *making, uint32_t side, uint32_t h)
{
    uint32_t levels = 2;
    for (uint32_t k = side; k > 1; k /= 2)
        levels++;
    uint32_t *from = allocate(h, sizeof *from);
    uint32_t *room = allocate((size_t)levels * h, sizeof *room);
    for (uint32_t k = 0; k < h; k++)
        from[k] = k;
    making->enough = (size_t)4 * side * (h + side);
    divide(making, (struct square){0, 0, side}, from, h, room);
    free(room);
    free(from);
}

static struct points measured_from(struct points p, double left,
                                   double bottom)
{
    struct points measured = points_allocate(p.n);
    for (uint32_t k = 0; k < p.n; k++) {
        measured.x[k] = p.x[k] - left;
        measured.y[k] = p.y[k] - bottom;
    }
    return measured;
}

struct regions regions_make(const struct corners *corners, uint32_t n)
{
    const struct points p = corners->points;
    double left, right, bottom, top;
    find_box(p, &left, &right, &bottom, &top);
    const double width = right - left, height = top - bottom;
    const double diagonal2 = distance2(width, height);
    const bool fits = diagonal2 > LEAST_D2 && diagonal2 < MOST_D2;
    const uint32_t side = fits ? side_for(n, p.n) : 1;
    struct regions regions = {.side = side, .corners = p.n};
    if (fits) { // else any x * 0 is 0, and in the only one
        regions.left = left, regions.across = regions_per(side, width);
        regions.bottom = bottom, regions.up = regions_per(side, height);
    }
    regions.region =
        allocate((size_t)side * side, sizeof *regions.region);
    struct making making = {.points = measured_from(p, left, bottom),
                            .width = width,
                            .height = height,
                            .margin =
                                fits ? diagonal2 * 0x1p-46 : INFINITY,
                            .regions = &regions};
    // If all squared distances vanish, one corner is enough.
    make_lists(&making, side, diagonal2 > 0 ? p.n : 1);
    points_free(&making.points);
    return regions;
}

void regions_free(struct regions *regions)
{
    free(regions->region);
    free(regions->list);
    *regions = (struct regions){0};
}
//<

//> Find the region of every point of a strip
enum { STRIP = 512 };

static inline uint32_t region_on(double x, double low, double scale,
                                 uint32_t side)
{
    int32_t k = (int32_t)((x - low) * scale);
    return k < (int32_t)side ? (uint32_t)k : side - 1;
}

static void find_regions(const struct regions *regions,
                         struct points strip, uint32_t *home)
{
    const struct regions r = *regions;
    for (uint32_t i = 0; i < strip.n; i++)
        home[i] =
            region_on(strip.y[i], r.bottom, r.up, r.side) * r.side +
            region_on(strip.x[i], r.left, r.across, r.side);
}
//<

//> Compare the corners of a list
static uint32_t furthest_of(struct points corners, const uint32_t *list,
                            double x, double y)
{
    const uint32_t count = list[0];
    double most2 = -1;
    uint32_t far = list[1];
    for (uint32_t k = 1; k <= count; k++) {
        double d2 =
            distance2(corners.x[list[k]] - x, corners.y[list[k]] - y);
        if (d2 > most2) // of a tie the first has the lowest index
            most2 = d2, far = list[k];
    }
    COUNT(distances, count);
    return far;
}
//<

//> Search a strip
static void search_strip(const struct question *question,
                         const struct corners *corners,
                         const struct regions *regions, uint32_t begin,
                         struct answers *answers)
{
    const struct points p = question->points, c = corners->points;
    const uint32_t left = p.n - begin;
    const struct points strip = {left < STRIP ? left : STRIP,
                                 p.x + begin, p.y + begin};
    uint32_t *furthest = answers->furthest + begin;
    double *furthest2 = answers->furthest2 + begin;
    uint32_t home[STRIP];
    find_regions(regions, strip, home);
    for (uint32_t i = 0; i < strip.n; i++) {
        double x = strip.x[i], y = strip.y[i];
        uint32_t far = regions->region[home[i]];
        if (far >= c.n)
            far = furthest_of(c, regions->list + (far - c.n), x, y);
        furthest[i] = corners->point[far];
        furthest2[i] = distance2(c.x[far] - x, c.y[far] - y);
        if (furthest2[i] == 0) // so are all
            furthest[i] = begin + i == 0;
    }
    COUNT(distances, strip.n);
}
//<

void search_regions(const struct question *question,
                    const struct corners *corners,
                    const struct regions *regions,
                    struct answers *answers)
{
    const uint32_t strips = (question->points.n - 1) / STRIP + 1;
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic)
    for (uint32_t k = 0; k < strips; k++)
        search_strip(question, corners, regions, k * STRIP, answers);
}
//<
