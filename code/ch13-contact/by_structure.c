//> Find pairs by range queries
// A class holds boxes between a width and a quarter of it. A box asks
// its own class and those of smaller boxes; so every pair of classes is
// asked once, by the larger box, and of the smaller ones only the width
// counts. A box costs a query of chapter 12 for each class that it
// asks, and a test for each corner that is found.
#include "ch13-contact/by_structure.h"
#include "ch12-range-queries/structures.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

//> Hold classes of size
enum { CLASSES = 8 };

struct size_class {
    struct point_set points; // low corners; n = 0: an empty class
    uint32_t *member;        // which triangles they are
    void *built;
    double width[3]; // the greatest now, along each coordinate
    double bound;    // the greatest that a member may have
};

struct classes {
    const struct structure *structure;
    struct size_class class[CLASSES]; // the largest boxes first
    uint32_t n;                       // boxes in all
    uint8_t *class_of;                // of each box
    uint32_t **found;                 // room for each thread
    int threads;
};

void *begin_structure(const struct broad_phase *phase)
{
    struct classes *classes = allocate(1, sizeof *classes);
    *classes =
        (struct classes){.structure = find_structure(phase->inner)};
    return classes;
}
//<

//> Give up the classes
static void discard_classes(struct classes *classes)
{
    for (int c = 0; c < CLASSES; c++) {
        struct size_class *class = &classes->class[c];
        if (class->points.n == 0)
            continue;
        classes->structure->discard(class->built);
        point_set_free(&class->points);
        free(class->member);
        *class = (struct size_class){0};
    }
    free(classes->class_of);
    for (int k = 0; k < classes->threads; k++)
        free(classes->found[k]);
    free(classes->found);
    *classes = (struct classes){classes->structure};
}

void end_structure(void *kept)
{
    discard_classes(kept);
    free(kept);
}
//<

//> Measure a box
// Rounded up: no box is wider than that.
static double width_along(const struct boxes *boxes, int k, uint32_t t)
{
    return nextafter(boxes->high[k][t] - boxes->low[k][t], INFINITY);
}

static double width_of(const struct boxes *boxes, uint32_t t)
{
    const double x = width_along(boxes, 0, t);
    const double y = width_along(boxes, 1, t);
    const double z = width_along(boxes, 2, t);
    return MAX(x, MAX(y, z));
}
//<

//> Part boxes into classes
// By two binary digits of the width each; the last has the rest.
static void part_boxes(struct classes *classes,
                       const struct boxes *boxes)
{
    uint32_t count[CLASSES] = {0};
    double widest = 0;
    for (uint32_t t = 0; t < boxes->n; t++)
        widest = MAX(widest, width_of(boxes, t));
    classes->n = boxes->n;
    classes->class_of = allocate(boxes->n, 1);
    for (uint32_t t = 0; t < boxes->n; t++) {
        const int c = (int)MIN(ilogb(widest / width_of(boxes, t)) / 2,
                               CLASSES - 1);
        classes->class_of[t] = (uint8_t)c;
        count[c]++;
    }
    for (int c = 0; c < CLASSES; c++) {
        struct size_class *class = &classes->class[c];
        if (count[c] == 0)
            continue;
        class->points = point_set_allocate(count[c], 3);
        class->member = allocate(count[c], sizeof *class->member);
        class->bound = 2 * ldexp(widest, -2 * c);
    }
}
//<

//> List the members of each class
static void list_members(struct classes *classes)
{
    uint32_t count[CLASSES] = {0};
    for (uint32_t t = 0; t < classes->n; t++) {
        const int c = classes->class_of[t];
        classes->class[c].member[count[c]++] = t;
    }
}

static void give_room(struct classes *classes, int threads)
{
    classes->threads = threads;
    classes->found = allocate(threads, sizeof *classes->found);
    for (int k = 0; k < threads; k++)
        classes->found[k] = allocate(classes->n, sizeof(uint32_t));
}
//<

//> Follow the boxes of a class
// Says whether all are still small enough for it.
static bool follow(struct size_class *class, const struct boxes *boxes)
{
    double widest = 0;
    for (int k = 0; k < 3; k++) {
        class->width[k] = 0;
        for (uint32_t m = 0; m < class->points.n; m++) {
            const uint32_t t = class->member[m];
            const double width = width_along(boxes, k, t);
            class->points.x[k][m] = boxes->low[k][t];
            class->width[k] = MAX(class->width[k], width);
        }
        widest = MAX(widest, class->width[k]);
    }
    return widest <= class->bound;
}
//<

//> Keep the structures from step to step
// As long as the boxes are as many and keep to their classes.
static bool update(struct classes *classes, const struct boxes *boxes,
                   int threads)
{
    if (classes->n != boxes->n || classes->threads != threads)
        return false;
    for (int c = 0; c < CLASSES; c++)
        if (!follow(&classes->class[c], boxes))
            return false;
    for (int c = 0; c < CLASSES; c++) {
        struct size_class *class = &classes->class[c];
        if (class->points.n > 0)
            class->built =
                structure_update(classes->structure, class->built,
                                 &class->points, threads);
    }
    return true;
}
//<

//> Build the classes
static void build(struct classes *classes, const struct boxes *boxes,
                  int threads)
{
    discard_classes(classes);
    part_boxes(classes, boxes);
    list_members(classes);
    give_room(classes, threads);
    for (int c = 0; c < CLASSES; c++) {
        struct size_class *class = &classes->class[c];
        follow(class, boxes);
        if (class->points.n > 0)
            class->built =
                classes->structure->build(&class->points, threads);
    }
}
//<

//> Ask a class for a box
// Within its own class a box asks only for low corners that are not to
// the left of its own: of each pair, one of the two finds the other.
static void ask_class(const struct broad_search *search,
                      const struct classes *classes, int c, uint32_t i)
{
    const struct boxes *boxes = search->boxes;
    const struct size_class *class = &classes->class[c];
    const bool own = classes->class_of[i] == c;
    const int thread = omp_get_thread_num();
    struct pair_list *list = &search->pairs->list[thread];
    struct report report = {classes->found[thread]};
    struct range range = {0};
    for (int k = 0; k < 3; k++) {
        range.low[k] =
            nextafter(boxes->low[k][i] - class->width[k], -INFINITY);
        range.high[k] = boxes->high[k][i];
    }
    if (own)
        range.low[0] = boxes->low[0][i];
    classes->structure->query(class->built, &range, &report);
    for (uint32_t f = 0; f < report.count; f++) {
        const uint32_t j = class->member[report.found[f]];
        if (!own || boxes->low[0][j] > boxes->low[0][i] || j > i)
            add_if_overlapping(search, list, i, j);
    }
    list->tested += report.tested + report.count;
}
//<

//> Ask for every box
void find_by_structure(void *kept, const struct broad_search *search)
{
    struct classes *classes = kept;
    const int threads = search->threads;
    if (!update(classes, search->boxes, threads))
        build(classes, search->boxes, threads);
#pragma omp parallel for num_threads(threads) if (threads > 1) \
    schedule(dynamic, 256)
    for (uint32_t i = 0; i < classes->n; i++)
        for (int c = classes->class_of[i]; c < CLASSES; c++)
            if (classes->class[c].points.n > 0)
                ask_class(search, classes, c, i);
}
//<
//<
