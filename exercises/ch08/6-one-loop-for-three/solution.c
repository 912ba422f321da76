// All lanes measure in every round, wherever on its way each of them
// is. Before a round, the lanes whose cells are exhausted are sent to
// the next one, together, and again, until their cells have points.
#include "exercise.h"

//- solution
// A lane's task, the cells it has visited, the next of its places and
// where they end.
struct lanes {
    uint32_t n;
    uint32_t task[STRIP], visited[STRIP], place[STRIP], end[STRIP];
};

// The tasks that need a cell, and their lanes.
struct waiting {
    uint32_t n;
    uint32_t lane[STRIP], task[STRIP], visited[STRIP], cell[STRIP];
};

static void add(struct waiting *waiting, const struct lanes *lanes,
                uint32_t lane)
{
    waiting->lane[waiting->n] = lane;
    waiting->task[waiting->n] = lanes->task[lane];
    waiting->visited[waiting->n] = lanes->visited[lane];
    waiting->n++;
}

// Sends the lanes to their cells; one in an empty cell is sent on.
static void go_on(struct waiting *waiting, struct lanes *lanes,
                  const uint32_t *start)
{
    uint32_t n = waiting->n;
    waiting->n = 0;
    for (uint32_t a = 0; a < n; a++) {
        uint32_t lane = waiting->lane[a], cell = waiting->cell[a];
        if (cell == NOWHERE)
            continue;
        lanes->visited[lane]++;
        lanes->place[lane] = start[cell];
        lanes->end[lane] = start[cell + 1];
        if (start[cell] == start[cell + 1])
            add(waiting, lanes, lane);
    }
}

static void refill(struct lanes *lanes, const uint32_t *start)
{
    struct waiting waiting = {.n = 0};
    for (uint32_t l = 0; l < lanes->n; l++)
        if (lanes->place[l] == lanes->end[l])
            add(&waiting, lanes, l);
    while (waiting.n > 0) {
        next_cell(waiting.n, waiting.task, waiting.visited,
                  waiting.cell);
        go_on(&waiting, lanes, start);
    }
}

// A lane that still has no place has finished.
static void pack(struct lanes *lanes)
{
    uint32_t kept = 0;
    for (uint32_t l = 0; l < lanes->n; l++) {
        lanes->task[kept] = lanes->task[l];
        lanes->visited[kept] = lanes->visited[l];
        lanes->place[kept] = lanes->place[l];
        lanes->end[kept] = lanes->end[l];
        kept += lanes->place[l] < lanes->end[l];
    }
    lanes->n = kept;
}

//- starter
//- end
void seek(uint32_t n, const uint32_t *start)
{
    //- solution
    struct lanes lanes = {.n = n};
    for (uint32_t l = 0; l < n; l++) {
        lanes.task[l] = l;
        lanes.visited[l] = lanes.place[l] = lanes.end[l] = 0;
    }
    for (;;) {
        refill(&lanes, start);
        pack(&lanes);
        if (lanes.n == 0)
            return;
        measure(lanes.n, lanes.task, lanes.place);
        for (uint32_t l = 0; l < lanes.n; l++)
            lanes.place[l]++;
    }
    //- starter
    // // Your turn: so far each task goes to one cell, and measures
    // // its first point.
    // uint32_t task[STRIP] = {0}, visited[STRIP] = {0};
    // uint32_t cell[STRIP] = {0}, lanes = 0;
    // for (uint32_t l = 0; l < n; l++)
    //     task[l] = l;
    // next_cell(n, task, visited, cell);
    // for (uint32_t l = 0; l < n; l++) {
    //     uint32_t place = start[cell[l]];
    //     if (place == start[cell[l] + 1])
    //         continue;
    //     task[lanes] = l;
    //     cell[lanes++] = place;
    // }
    // measure(lanes, task, cell);
    //- end
}
