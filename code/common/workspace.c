//> Keep memory from search to search
// A stack of blocks, each at least as large as the array it was first
// wanted for. The system clears each page when it is touched for the
// first time, which costs more than a search does with it; memory that
// is kept has been cleared. So the second search of as many points
// allocates nothing and touches no new page. A caller that
// takes an array needs a mark from before, to give it up again.
#include "common/workspace.h"
#include "common/allocate.h"
#include "common/fail.h"
#include "common/min_max.h"
#include <assert.h>
#include <stdint.h>
#include <stdlib.h>

enum { LINE = 64, MIN_BLOCK = 1 << 16, SMALL_PAGE = 4096 };

//> Find a block with room
// A block beyond the last is empty. One that is empty and too small is
// given back for a larger one.
void workspace_reserve(struct workspace *workspace, size_t bytes,
                       int threads)
{
    struct block_of_memory *block = &workspace->block[workspace->last];
    if (block->size - block->used >= bytes)
        return;
    if (block->used > 0) {
        workspace->last++;
        assert(workspace->last < WORKSPACE_BLOCKS &&
               "few arrays are taken beside what was reserved");
        block++;
        if (block->size >= bytes)
            return;
    }
    free(block->memory);
    block->size = MAX(bytes, MIN_BLOCK);
    block->memory = allocate(block->size, 1);
    //> Touch fresh pages
    // By as many threads as will use them: the pages are handed out to
    // several threads at a time, and near the processor that asks.
#pragma omp parallel for num_threads(threads) if (threads > 1)
    for (size_t at = 0; at < block->size; at += SMALL_PAGE)
        block->memory[at] = 0;
    //<
}
//<

//> Take an array from the top
void *workspace_take(struct workspace *workspace, size_t count,
                     size_t size)
{
    if (size && count > (SIZE_MAX / 2 - LINE) / size)
        fail("%zu times %zu bytes are too many", count, size);
    const size_t bytes = (count * size + LINE - 1) / LINE * LINE;
    workspace_reserve(workspace, bytes, 1);
    struct block_of_memory *block = &workspace->block[workspace->last];
    void *array = block->memory + block->used;
    block->used += bytes;
    return array;
}
//<

//> Note the height of the stack
struct mark workspace_mark(const struct workspace *workspace)
{
    return (struct mark){workspace->last,
                         workspace->block[workspace->last].used};
}
//<

//> Give up what was taken since
void workspace_release(struct workspace *workspace, struct mark mark)
{
    assert(mark.last <= workspace->last && "the mark is on the stack");
    for (; workspace->last > mark.last; workspace->last--)
        workspace->block[workspace->last].used = 0;
    workspace->block[mark.last].used = mark.used;
}
//<

void workspace_free(struct workspace *workspace)
{
    for (int k = 0; k < WORKSPACE_BLOCKS; k++)
        free(workspace->block[k].memory);
    *workspace = (struct workspace){0};
}
//<
