//> Make room for a strip
// See strip.h. All arrays are cut from one block, and each is longer by
// what a pack may spill.
#include "ch08-vector-spiral/strip.h"
#include "common/fail.h"
#include <stdlib.h>

//> Cut arrays from a block
struct room {
    char *next;
    size_t length;
};

static void *cut(struct room *room, size_t size)
{
    void *array = room->next;
    room->next += room->length * size;
    return array;
}

static struct tasks cut_tasks(struct room *room)
{
    struct tasks tasks = {
        .task = cut(room, sizeof(uint32_t)),
        .column = cut(room, sizeof(int32_t)),
        .row = cut(room, sizeof(int32_t)),
    };
    for (int side = 0; side < SIDES; side++)
        tasks.reach[side] = cut(room, sizeof(int32_t));
    return tasks;
}
//<

// The numbers of doubles and of 32-bit numbers that a task has.
enum { DOUBLES = 8, NUMBERS = 22 };

size_t strip_bytes(uint32_t length)
{
    return length * (DOUBLES * sizeof(double) +
                     NUMBERS * sizeof(uint32_t) + sizeof(uint8_t));
}

struct strip strip_allocate(const struct primitives *primitives,
                            uint32_t length)
{
    struct room room = {.length = (size_t)length + SPILL};
    room.next = allocate(room.length, strip_bytes(1));
    struct strip strip = {.x = cut(&room, sizeof(double)),
                          .y = cut(&room, sizeof(double)),
                          .best2 = cut(&room, sizeof(double)),
                          .point_x = cut(&room, sizeof(double)),
                          .point_y = cut(&room, sizeof(double)),
                          .task_x = cut(&room, sizeof(double)),
                          .task_y = cut(&room, sizeof(double)),
                          .best = cut(&room, sizeof(double)),
                          .nearest = cut(&room, sizeof(uint32_t)),
                          .ended = cut(&room, sizeof(int32_t)),
                          .cell = cut(&room, sizeof(uint32_t)),
                          .point = cut(&room, sizeof(uint32_t)),
                          .least = cut(&room, sizeof(uint32_t)),
                          .here = {0, cut(&room, sizeof(uint32_t)),
                                   cut(&room, sizeof(uint32_t)),
                                   cut(&room, sizeof(uint32_t))},
                          .all = cut_tasks(&room),
                          .some = cut_tasks(&room),
                          .keep = cut(&room, sizeof(uint8_t)),
                          .primitives = primitives};
    for (uint32_t t = 0; t < length; t++)
        strip.all.task[t] = t;
    return strip;
}

void strip_free(struct strip *strip)
{
    free(strip->x); // where the block begins
    *strip = (struct strip){0};
}
//<
