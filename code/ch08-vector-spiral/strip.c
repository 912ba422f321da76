//> Make room for a strip
// All arrays of a strip are cut from one block, the widest elements
// first so that each is aligned, and each array is longer by
// what a pack may spill.
#include "ch08-vector-spiral/strip.h"
#include "common/allocate.h"
#include <assert.h>
#include <stdlib.h>

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
        tasks.bound[side] = cut(room, sizeof(int32_t));
    return tasks;
}

// In this order: the block begins with x, and ends with the bytes, so
// that all others are aligned.
struct strip strip_allocate(const struct primitives *primitives,
                            uint32_t length)
{
    struct room room = {.length = (size_t)length + SPILL};
    room.next = allocate(room.length, TASK_BYTES);
    struct strip strip = {.primitives = primitives};
    strip.x = cut(&room, sizeof(double));
    strip.y = cut(&room, sizeof(double));
    strip.best2 = cut(&room, sizeof(double));
    strip.point_x = cut(&room, sizeof(double));
    strip.point_y = cut(&room, sizeof(double));
    strip.task_x = cut(&room, sizeof(double));
    strip.task_y = cut(&room, sizeof(double));
    strip.best = cut(&room, sizeof(double));
    strip.nearest = cut(&room, sizeof(uint32_t));
    strip.phase_one_layer = cut(&room, sizeof(int32_t));
    strip.cell = cut(&room, sizeof(uint32_t));
    strip.point = cut(&room, sizeof(uint32_t));
    strip.gathered_nearest = cut(&room, sizeof(uint32_t));
    strip.here.task = cut(&room, sizeof(uint32_t));
    strip.here.at = cut(&room, sizeof(uint32_t));
    strip.here.end = cut(&room, sizeof(uint32_t));
    strip.all = cut_tasks(&room);
    strip.layer = cut_tasks(&room);
    strip.keep = cut(&room, sizeof(uint8_t));
    assert((size_t)(room.next - (char *)strip.x) ==
               room.length * TASK_BYTES &&
           "all is cut that was counted");
    for (uint32_t t = 0; t < length; t++)
        strip.all.task[t] = t;
    return strip;
}

void strip_free(struct strip *strip)
{
    free(strip->x); // where the block begins
    *strip = (struct strip){0};
}

//> Add up tallies
void tally_add(struct tally *sum, const struct tally *tally)
{
    sum->tasks += tally->tasks;
    for (int k = 0; k < LAYERS_TALLIED; k++) {
        sum->phase_one[k] += tally->phase_one[k];
        sum->phase_two[k] += tally->phase_two[k];
        sum->of_layer[k] += tally->of_layer[k];
    }
    sum->listed += tally->listed;
    sum->bound_steps += tally->bound_steps;
    sum->tried += tally->tried;
    sum->visited += tally->visited;
    sum->entered += tally->entered;
    sum->compared += tally->compared;
    sum->cell_steps += tally->cell_steps;
    sum->point_rounds += tally->point_rounds;
    sum->lanes += tally->lanes;
    sum->lanes_unpacked += tally->lanes_unpacked;
}
//<
//<
