//> Build the orthotree
// One sort by Morton numbers, in linear time; then each node's children
// are stretches of its own, found in one pass for each level.
#include "ch12-range-queries/orthotree.h"
#include "ch12-range-queries/radix_sort.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

//> Number the points by Morton
// Each bit of a byte moves to d times its place; so eight bits of a
// bin are spread at once.
static struct radix_record *number(const struct orthotree *tree,
                                   const struct point_set *points)
{
    const int d = points->d;
    uint64_t spread[256] = {0};
    for (int byte = 0; byte < 256; byte++)
        for (int bit = 0; bit < 8; bit++)
            spread[byte] |= (uint64_t)(byte >> bit & 1) << bit * d;
    struct radix_record *record = allocate(points->n, sizeof *record);
    for (uint32_t i = 0; i < points->n; i++)
        record[i] = (struct radix_record){0, i};
    for (int k = 0; k < d; k++)
        for (uint32_t i = 0; i < points->n; i++) {
            const uint32_t bin = bin_along(tree, k, points->x[k][i]);
            for (int bit = 0; bit < tree->levels; bit += 8)
                record[i].key |= spread[bin >> bit & 255]
                                 << (bit * d + k);
        }
    return record;
}
//<

//> Add a node
static uint32_t add_node(struct orthotree *tree, struct ortho_node node)
{
    if (tree->count == tree->room) {
        struct ortho_node *before = tree->node;
        tree->room = 2 * tree->room + 64;
        tree->node = allocate(tree->room, sizeof *tree->node);
        if (before)
            memcpy(tree->node, before, tree->count * sizeof *before);
        free(before);
    }
    tree->node[tree->count] = node;
    return tree->count++;
}
//<

//> Add the children of a node
// They are at one level: all of them, or those that are not empty.
static void add_children(struct orthotree *tree, uint32_t parent,
                         const struct radix_record *record)
{
    const struct ortho_node node = tree->node[parent];
    const uint32_t children = 1u << tree->sorted.points.d;
    uint32_t begin = node.begin, first = tree->count;
    for (uint32_t child = 0; child < children; child++) {
        uint32_t end = begin;
        while (end < node.end &&
               child_of(tree, record[end].key, node.level) == child)
            end++;
        if (end > begin || !tree->compressed)
            add_node(tree, (struct ortho_node){
                               end > begin ? record[begin].key : 0,
                               begin, end, 0, 0, node.level + 1});
        begin = end;
    }
    tree->node[parent].first_child = first;
    tree->node[parent].children = (uint16_t)(tree->count - first);
}
//<

//> Cut a node
// The compressed form goes on to the level where the first and the last
// of its points separate.
static void cut(struct orthotree *tree, uint32_t number,
                const struct radix_record *record)
{
    struct ortho_node *node = &tree->node[number];
    if (node->end - node->begin <= 1)
        return;
    const uint64_t first = record[node->begin].key;
    const uint64_t last = record[node->end - 1].key;
    while (tree->compressed && node->level < tree->levels &&
           child_of(tree, first, node->level) ==
               child_of(tree, last, node->level))
        node->level++;
    if (node->end - node->begin <= tree->leaf_size ||
        node->level == tree->levels)
        return;
    add_children(tree, number, record);
    const struct ortho_node now = tree->node[number]; // it may move
    for (uint32_t child = 0; child < now.children; child++)
        cut(tree, now.first_child + child, record);
}
//<

struct orthotree ortho_make(const struct point_set *points,
                            uint32_t leaf_size, bool compressed)
{
    const uint32_t n = points->n;
    struct orthotree tree = {
        sorted_points_allocate(n, points->d), range_of(points, 0, n),
        .levels = MIN(64 / points->d, MAX_LEVELS),

        .leaf_size = leaf_size, .compressed = compressed};
    for (int k = 0; k < points->d; k++) {
        const double width = tree.range.high[k] - tree.range.low[k];
        tree.scale[k] = width > 0 ? ldexp(1, tree.levels) / width : 0;
    }
    struct radix_record *record = number(&tree, points);
    struct radix_record *room = allocate(n, sizeof *room);
    radix_sort(record, n, tree.levels * points->d, room);
    free(room);
    for (uint32_t s = 0; s < n; s++)
        tree.sorted.index[s] = record[s].point;
    sorted_points_fill(&tree.sorted, points);
    add_node(&tree, (struct ortho_node){record[0].key, 0, n, 0, 0, 0});
    cut(&tree, 0, record);
    free(record);
    return tree;
}

void ortho_free(struct orthotree *tree)
{
    sorted_points_free(&tree->sorted);
    free(tree->node);
}

size_t ortho_bytes(const struct orthotree *tree)
{
    return sorted_points_bytes(&tree->sorted) +
           tree->count * sizeof *tree->node;
}
//<
