//> List the structures
// What is built goes to the heap, where the caller cannot see what it
// is.
#include "ch12-range-queries/structures.h"
#include "ch12-range-queries/cell_array.h"
#include "ch12-range-queries/kd_tree.h"
#include "ch12-range-queries/orthotree.h"
#include "ch12-range-queries/projection.h"
#include "common/allocate.h"
#include <stdlib.h>
#include <string.h>

static void *keep(const void *made, size_t size)
{
    return memcpy(allocate(1, size), made, size);
}

//> Wrap the scans
static void *build_scan(const struct point_set *points, int threads)
{
    (void)threads;
    return keep(points, sizeof *points);
}

static void update_scan(void *built, const struct point_set *points)
{
    *(struct point_set *)built = *points;
}

static void query_scan(const void *built, const struct range *range,
                       struct report *report)
{
    scan_points(built, range, report);
}

static void query_lanes(const void *built, const struct range *range,
                        struct report *report)
{
    scan_lanes(built, range, report);
}

static void neighbors_scan(const void *built,
                           struct neighbor_query *query)
{
    scan_neighbors(built, query);
}

static size_t bytes_scan(const void *built)
{
    (void)built;
    return 0; // beside the points themselves
}
//<

//> Wrap the projection
static void *build_projection(const struct point_set *points,
                              int threads)
{
    (void)threads;
    const struct projection made = projection_make(points);
    return keep(&made, sizeof made);
}

static void update_projection(void *built,
                              const struct point_set *points)
{
    (void)points; // they are where they were
    projection_update(built);
}

static void query_projection(const void *built,
                             const struct range *range,
                             struct report *report)
{
    projection_query(built, range, report);
}

static size_t bytes_projection(const void *built)
{
    return projection_bytes(built);
}

static void discard_projection(void *built)
{
    projection_free(built);
    free(built);
}
//<

//> Wrap the k-d tree
static void *build_kd(const struct point_set *points, int threads)
{
    const struct kd_tree made = kd_make(points, KD_LEAF_SIZE, threads);
    return keep(&made, sizeof made);
}

static void refit_kd(void *built, const struct point_set *points)
{
    kd_refit(built, points);
}

static void rebuild_kd(void *built, const struct point_set *points)
{
    kd_rebuild(built, points);
}

static void query_kd(const void *built, const struct range *range,
                     struct report *report)
{
    kd_query(built, range, report);
}

static void neighbors_kd(const void *built,
                         struct neighbor_query *query)
{
    kd_neighbors(built, query);
}

static const struct sorted_points *order_kd(const void *built)
{
    return &((const struct kd_tree *)built)->sorted;
}

static size_t bytes_kd(const void *built)
{
    return kd_bytes(built);
}

static void discard_kd(void *built)
{
    kd_free(built);
    free(built);
}
//<

//> Wrap the orthotree
static void *build_ortho(const struct point_set *points, int threads)
{
    (void)threads;
    const struct orthotree made =
        ortho_make(points, ORTHO_LEAF_SIZE, false);
    return keep(&made, sizeof made);
}

static void *build_compressed(const struct point_set *points,
                              int threads)
{
    (void)threads;
    const struct orthotree made =
        ortho_make(points, ORTHO_LEAF_SIZE, true);
    return keep(&made, sizeof made);
}

static void query_ortho(const void *built, const struct range *range,
                        struct report *report)
{
    ortho_query(built, range, report);
}

static size_t bytes_ortho(const void *built)
{
    return ortho_bytes(built);
}

static void discard_ortho(void *built)
{
    ortho_free(built);
    free(built);
}
//<

//> Wrap the cells
static void *build_cells(const struct point_set *points, int threads)
{
    (void)threads;
    const struct cell_array made =
        cell_array_make(points, POINTS_PER_CELL, false);
    return keep(&made, sizeof made);
}

static void *build_sorted_cells(const struct point_set *points,
                                int threads)
{
    (void)threads;
    const struct cell_array made =
        cell_array_make(points, POINTS_PER_CELL, true);
    return keep(&made, sizeof made);
}

static void query_cells(const void *built, const struct range *range,
                        struct report *report)
{
    cell_array_query(built, range, report);
}

static void neighbors_cells(const void *built,
                            struct neighbor_query *query)
{
    cell_array_neighbors(built, query);
}

static const struct sorted_points *order_cells(const void *built)
{
    return &((const struct cell_array *)built)->sorted;
}

static size_t bytes_cells(const void *built)
{
    return cell_array_bytes(built);
}

static void discard_cells(void *built)
{
    cell_array_free(built);
    free(built);
}
//<

//> Fill the table
const struct structure structures[] = {
    {"scan", "one point after the other", build_scan, update_scan,
     query_scan, neighbors_scan, NULL, bytes_scan, free},
    {"scan-lanes", "several points at once", build_scan, update_scan,
     query_lanes, neighbors_scan, NULL, bytes_scan, free},
    {"projection", "sorted references for each coordinate",
     build_projection, update_projection, query_projection, NULL, NULL,
     bytes_projection, discard_projection},
    {"kd-tree", "cut at medians; motion refits it", build_kd, refit_kd,
     query_kd, neighbors_kd, order_kd, bytes_kd, discard_kd},
    {"kd-tree-anew", "the same, built anew after motion", build_kd,
     rebuild_kd, query_kd, neighbors_kd, order_kd, bytes_kd,
     discard_kd},
    {"orthotree", "cut at midpoints, 2^d parts", build_ortho, NULL,
     query_ortho, NULL, NULL, bytes_ortho, discard_ortho},
    {"orthotree-compressed", "the same without idle nodes",
     build_compressed, NULL, query_ortho, NULL, NULL, bytes_ortho,
     discard_ortho},
    {"cells", "cells of equal width", build_cells, NULL, query_cells,
     neighbors_cells, order_cells, bytes_cells, discard_cells},
    {"cells-halves", "the same with binary search inside of cells",
     build_sorted_cells, NULL, query_cells, neighbors_cells,
     order_cells, bytes_cells, discard_cells},
};
const int structure_count = sizeof structures / sizeof *structures;
//<
//<
