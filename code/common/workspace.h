//> Declare the workspace
// Memory for searches, owned by their caller: a stack of arrays. What a
// stage no longer needs, the next one takes over, and what a search
// needed is there for the next search. A search that is given no
// workspace makes one for itself and frees it in the end.
#pragma once
#include <stddef.h>

//> Hold memory in blocks
// Few large blocks, filled one after the other; an array never spans
// two. {0} is an empty one. Not for two threads at a time.
enum { WORKSPACE_BLOCKS = 24 };

struct workspace {
    int last; // the block that is being filled
    struct block_of_memory {
        char *memory;
        size_t size, used; // in bytes
    } block[WORKSPACE_BLOCKS];
};
//<

// An array of count elements of size bytes each, 64-byte aligned, not
// cleared. Never NULL; ends the program if memory is short.
void *workspace_take(struct workspace *workspace, size_t count,
                     size_t size);

// Makes sure that the arrays taken next, so many bytes together, lie in
// one block. If that is new, the threads touch it all, each a part, so
// that the pages are there before time is taken or work is shared out.
void workspace_reserve(struct workspace *workspace, size_t bytes,
                       int threads);

// The height of the stack; and back to it: all arrays taken since are
// given up, their memory is kept.
//> Mark the height of the stack
struct mark {
    int last;
    size_t used;
};
//<
struct mark workspace_mark(const struct workspace *workspace);
void workspace_release(struct workspace *workspace, struct mark mark);

// Gives all memory back to the system. Empty again.
void workspace_free(struct workspace *workspace);
//<
