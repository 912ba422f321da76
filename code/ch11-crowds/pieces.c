//> Make the pieces
// Chapter 5's partition with a splitter tree in place of a grid: count
// the points of every leaf, scan, write each point's record to its
// leaf; then every leaf grows by itself, inside a cache.
#include "ch11-crowds/pieces.h"
#include "ch05-collisions/shared.h"
#include "ch11-crowds/grow.h"
#include "common/chunk.h"
#include "common/min_max.h"
#include <math.h>
#include <string.h>

// Where a leaf's records and what becomes of them are some 300 KB: a
// part of a second-level cache.
enum { POINTS_PER_LEAF = 4096, STRIP = 512 };

//> Hold what sends the points
struct sending {
    struct points points;
    int chunks;
    const struct splitter_tree *tree;
    uint32_t *leaf;  // of each point, where its record's number will be
    uint32_t *next;  // next[chunk * leaves + leaf]
    uint32_t *begin; // begin[0 .. leaves], of records
    struct point_record *record;
};
//<

//> Count the points of every leaf
static void count_leaves(const struct sending *sending, int k)
{
    const struct points p = sending->points;
    const uint32_t leaves = sending->tree->leaves;
    uint32_t *mine = sending->next + (size_t)k * leaves;
    uint32_t i = chunk_begin(p.n, k, sending->chunks);
    const uint32_t end = chunk_begin(p.n, k + 1, sending->chunks);
    memset(mine, 0, leaves * sizeof *mine);
    for (uint32_t count; i < end; i += count) {
        count = MIN(end - i, STRIP);
        uint32_t *leaf = sending->leaf + i;
        splitter_tree_find(sending->tree, p.x + i, p.y + i, count,
                           leaf);
        for (uint32_t s = 0; s < count; s++)
            mine[leaf[s]]++;
    }
}
//<

//> Send every record to its leaf
static void send_chunk(const struct sending *sending, int k)
{
    const struct points p = sending->points;
    uint32_t *next = sending->next + (size_t)k * sending->tree->leaves;
    uint32_t i = chunk_begin(p.n, k, sending->chunks);
    const uint32_t end = chunk_begin(p.n, k + 1, sending->chunks);
    for (; i < end; i++) {
        const uint32_t at = next[sending->leaf[i]]++;
        sending->record[at] =
            (struct point_record){p.x[i], p.y[i], 0, i};
        sending->leaf[i] = at; // now it is the permutation
    }
}

//> Send all chunks
static void send_all(const struct sending *sending)
{
#pragma omp parallel for num_threads(sending->chunks)
    for (int k = 0; k < sending->chunks; k++)
        count_leaves(sending, k);
    scan_chunks(sending->next, sending->tree->leaves, sending->chunks,
                sending->begin);
#pragma omp parallel for num_threads(sending->chunks)
    for (int k = 0; k < sending->chunks; k++)
        send_chunk(sending, k);
}
//<
//<

//> Let all leaves grow
static void grow_all(const struct sending *sending,
                     const struct leaf_context *context)
{
    struct pieces *pieces = context->pieces;
    const uint32_t leaves = sending->tree->leaves;
#pragma omp parallel for num_threads(sending->chunks) schedule(dynamic)
    for (uint32_t k = 0; k < leaves; k++) {
        const uint32_t begin = sending->begin[k];
        const uint32_t slot = begin / POINTS_PER_SLOT + 2 * k;
        const struct leaf leaf = {begin, sending->begin[k + 1],
                                  sending->tree->region[k],
                                  leaves - 1 + 2 * slot, slot};
        pieces->first[k] = leaf.piece;
        pieces->count[k] = grow_leaf(context, &leaf);
    }
}
//<

//> Join the boxes
// Of the nodes above the leaves, from below.
//> Join two boxes
static void join(struct pieces *pieces, uint32_t k, uint32_t first,
                 uint32_t second)
{
    const struct node *a = &pieces->node[first];
    const struct node *b = &pieces->node[second];
    pieces->node[k] = (struct node){{fmin(a->box.left, b->box.left),
                                     fmax(a->box.right, b->box.right),
                                     fmin(a->box.bottom, b->box.bottom),
                                     fmax(a->box.top, b->box.top)},
                                    MIN(a->lowest, b->lowest),
                                    first,
                                    second,
                                    0};
}
//<

static uint32_t node_of(const struct pieces *pieces, uint32_t k)
{
    const uint32_t above = pieces->leaves - 1;
    return k < above ? k : above + 2 * pieces->first[k - above];
}

static void join_all(struct pieces *pieces)
{
    for (uint32_t k = pieces->leaves - 1; k-- > 0;)
        join(pieces, k, node_of(pieces, 2 * k + 1),
             node_of(pieces, 2 * k + 2));
}
//<

//> Take the arrays of the pieces
static struct pieces take_pieces(uint32_t n, uint32_t leaves,
                                 struct workspace *workspace)
{
    const size_t index = sizeof(uint32_t), number = sizeof(double);
    const size_t slots = piece_slots(n) + 2 * (size_t)leaves;
    return (struct pieces){
        .sorted.points = {n, workspace_take(workspace, n, number),
                          workspace_take(workspace, n, number)},
        .sorted.cells.point = workspace_take(workspace, n, index),
        .permutation = workspace_take(workspace, n, index),
        .inverse = workspace_take(workspace, n, index),
        .node = workspace_take(workspace, leaves + 2 * slots,
                               sizeof(struct node)),
        .piece = workspace_take(workspace, slots, sizeof(struct piece)),
        .leaves = leaves,
        .first = workspace_take(workspace, leaves, index),
        .count = workspace_take(workspace, leaves, index)};
}
//<

struct pieces pieces_make(const struct question *question,
                          struct workspace *workspace)
{
    const struct points p = question->points;
    const struct splitter_tree tree =
        splitter_tree_make(p, POINTS_PER_LEAF, workspace);
    const size_t slots = piece_slots(p.n) + 2 * (size_t)tree.leaves;
    struct pieces pieces = take_pieces(p.n, tree.leaves, workspace);
    struct leaf_context context = {
        .pieces = &pieces,
        .start = workspace_take(workspace, start_begin(p.n, slots),
                                sizeof(uint32_t)),
        .border = workspace_take(workspace, border_begin(p.n, slots),
                                 sizeof(double))};
    struct mark mark = workspace_mark(workspace);
    const int chunks = question->threads;
    context.record =
        workspace_take(workspace, p.n, sizeof *context.record);
    const struct sending sending = {
        p,
        chunks,
        &tree,
        pieces.permutation,
        workspace_take(workspace, (size_t)chunks * tree.leaves,
                       sizeof(uint32_t)),
        workspace_take(workspace, tree.leaves + 1, sizeof(uint32_t)),
        context.record};
    send_all(&sending);
    grow_all(&sending, &context);
    join_all(&pieces);
    workspace_release(workspace, mark);
    return pieces;
}
//<
