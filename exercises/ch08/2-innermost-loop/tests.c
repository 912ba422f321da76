// Tests of the innermost loop: which point each task was compared with,
// how many lanes and steps it took, and what was packed.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

static uint32_t tasks, points;
static uint32_t *cell_of_task, *start;

// What the student's process leaves behind; met has a row for each
// task, and a column for each point.
static uint8_t *met;
static struct notes {
    uint32_t steps, packs, idle_packs;
    uint64_t packed;
    enum { NOTHING, BAD_LANES, BAD_TASK, BAD_PLACE, BAD_PACK } fault;
    uint32_t lanes, task, place; // of the fault
    bool strayed;
    uint32_t stray_step, stray_task, stray_place; // of the first one
} * notes;

static uint32_t count_of(uint32_t cell)
{
    return start[cell + 1] - start[cell];
}

static void note(uint32_t task, uint32_t place)
{
    uint32_t cell = cell_of_task[task];
    uint8_t *mark = &met[(size_t)task * points + place];
    *mark += *mark < 2;
    bool stray = place < start[cell] || place >= start[cell + 1];
    if (notes->strayed || (!stray && *mark < 2))
        return;
    notes->strayed = true;
    notes->stray_step = notes->steps;
    notes->stray_task = task;
    notes->stray_place = place;
}

static void fault(int kind, uint32_t lanes, uint32_t task,
                  uint32_t place)
{
    notes->fault = kind;
    notes->lanes = lanes;
    notes->task = task;
    notes->place = place;
    kit_leave();
}

void measure(uint32_t lanes, const uint32_t *task,
             const uint32_t *place)
{
    if (lanes < 1 || lanes > tasks)
        fault(BAD_LANES, lanes, 0, 0);
    for (uint32_t l = 0; l < lanes; l++) {
        if (task[l] >= tasks)
            fault(BAD_TASK, lanes, task[l], 0);
        if (place[l] >= points)
            fault(BAD_PLACE, lanes, task[l], place[l]);
        note(task[l], place[l]);
    }
    notes->steps++;
}

uint32_t pack(uint32_t lanes, const uint8_t *keep, uint32_t *values)
{
    if (lanes > tasks)
        fault(BAD_PACK, lanes, 0, 0);
    uint32_t kept = 0;
    for (uint32_t l = 0; l < lanes; l++) {
        if (keep[l] > 1)
            fault(BAD_PACK, lanes, 0, 0);
        if (keep[l])
            values[kept++] = values[l];
    }
    notes->packs++;
    notes->idle_packs += kept == lanes;
    notes->packed += lanes;
    return kept;
}

// ---- inputs --------------------------------------------------------

// Cells of fewest to most points, then one of SPARE points that is
// no task's; and tasks, each for a cell at random.
enum { SPARE = 16 };

static void prepare(uint32_t n, uint32_t m, uint32_t fewest,
                    uint32_t most, uint64_t seed)
{
    struct random random = {seed};
    tasks = n, points = 0;
    start = kit_input("start", m + 2, sizeof *start);
    for (uint32_t k = 0; k < m; k++) {
        start[k] = points;
        points += fewest + random_bits(&random) % (most - fewest + 1);
    }
    start[m] = points;
    start[m + 1] = points += SPARE;
    cell_of_task = kit_input("cell of task", n, sizeof *cell_of_task);
    for (uint32_t i = 0; i < n; i++)
        cell_of_task[i] = random_bits(&random) % m;
    kit_given("%u tasks, %u cells of %u to %u points", n, m, fewest,
              most);
}

static struct strip strip_of_all(void)
{
    struct strip strip = {tasks,
                          kit_output("task", tasks, sizeof(uint32_t)),
                          kit_output("cell", tasks, sizeof(uint32_t)),
                          kit_output("place", tasks, sizeof(uint32_t)),
                          kit_output("keep", tasks, sizeof(uint8_t))};
    for (uint32_t i = 0; i < tasks; i++)
        strip.task[i] = i;
    memcpy(strip.cell, cell_of_task, tasks * sizeof *strip.cell);
    return strip;
}

// ---- checks --------------------------------------------------------

static const char *tell_task(uint32_t task)
{
    uint32_t cell = cell_of_task[task], count = count_of(cell);
    if (count == 0)
        return kit_text("task %u, cell %u, which is empty", task, cell);
    return kit_text("task %u, cell %u, places %u to %u", task, cell,
                    start[cell], start[cell + 1] - 1);
}

static void check_fault(void)
{
    switch (notes->fault) {
    case NOTHING:
        return;
    case BAD_LANES:
        WRONG(.expected = kit_text("a measure of 1 to %u lanes", tasks),
              .found = kit_text("%u lanes", notes->lanes),
              .cause = "When all tasks have finished, the loop ends. "
                       "There may be none to begin with.");
    case BAD_TASK:
        WRONG(.expected = kit_text("tasks 0 to %u", tasks - 1),
              .found = kit_text("task %u", notes->task),
              .cause = "Only the first elements of task are tasks; "
                       "pack says how many they still are.");
    case BAD_PLACE:
        WRONG(.where = tell_task(notes->task),
              .expected = kit_text("places below %u", points),
              .found = kit_text("place %u", notes->place),
              .cause =
                  "A lane has gone on after its cell was exhausted. "
                  "Are there fewer lanes after a pack?");
    case BAD_PACK:
        WRONG(.expected = kit_text("a pack of at most %u lanes, each "
                                   "with a keep of 0 or 1",
                                   tasks),
              .found = kit_text("a pack of %u lanes", notes->lanes),
              .cause = "Set keep for every lane before each pack, and "
                       "pack no more lanes than there are.");
    }
}

// Whether the test "all", which comes first, has said what is missing.
static bool told_elsewhere = true;

static const char *missing_cause(uint32_t task, uint32_t place)
{
    uint32_t b = place - start[cell_of_task[task]];
    if (notes->steps == 1 && b > 0)
        return told_elsewhere ? "The test \"all\" says why."
                              : "All tasks took one step only. Go on "
                                "until all have finished.";
    if (notes->strayed)
        return "It was compared with another point instead. The cell "
               "and the task of a lane must stay together: pack both, "
               "by the same flags.";
    if (b + 1 == count_of(cell_of_task[task]))
        return "It is the last one of its cell, and the task was gone. "
               "After the step to point b of a cell, b + 1 are done.";
    return "The task was packed away too early. A keep of 1 is for "
           "tasks that have not finished.";
}

static void run(void)
{
    struct strip strip = strip_of_all();
    met = kit_output("the notes", (size_t)tasks * points, 1);
    memset(met, 0, (size_t)tasks * points);
    notes = kit_output("the counts", 1, sizeof *notes);
    *notes = (struct notes){0};
    CALL(STUDENT(look_into_cells)(&strip, start));
    check_fault();
    for (uint32_t i = 0; i < tasks; i++)
        for (uint32_t p = start[cell_of_task[i]];
             p < start[cell_of_task[i] + 1]; p++)
            if (met[(size_t)i * points + p] == 0)
                WRONG(.where = tell_task(i),
                      .expected = kit_text("compared with place %u", p),
                      .found = "it never is",
                      .cause = missing_cause(i, p));
}

static const char *stray_cause(void)
{
    uint32_t task = notes->stray_task, place = notes->stray_place;
    uint32_t cell = cell_of_task[task], step = notes->stray_step;
    bool inside = place >= start[cell] && place < start[cell + 1];
    if (inside)
        return "It has been compared with this one before. Does every "
               "step take the next point? Are there fewer lanes after "
               "a "
               "pack?";
    if (place == start[cell + 1] && count_of(cell) == 0)
        return "An empty cell has no first point. Pack those tasks "
               "away before the first step.";
    if (place == start[cell + 1])
        return "That is one step too many: after the step to point b "
               "of a cell, b + 1 are done. No answer would ever show "
               "it.";
    if (place < points && place == start[cell] + step)
        return "A lane that has finished goes on with the others. Is "
               "it packed away, and are there fewer lanes then?";
    return "Is the place that of the lane's own cell? Cell and task "
           "must be packed by the same flags.";
}

static void check_no_other(void)
{
    run();
    if (notes->strayed)
        WRONG(.where = tell_task(notes->stray_task),
              .expected = "only points of its cell, once each",
              .found =
                  kit_text("place %u in step %u", notes->stray_place,
                           notes->stray_step + 1),
              .cause = stray_cause());
}

static void check_steps(void)
{
    uint32_t fullest = 0;
    for (uint32_t i = 0; i < tasks; i++)
        if (count_of(cell_of_task[i]) > fullest)
            fullest = count_of(cell_of_task[i]);
    check_no_other();
    if (notes->steps > fullest)
        WRONG(.expected = kit_text("%u steps, as many as the fullest "
                                   "cell has points",
                                   fullest),
              .found = kit_text("%u", notes->steps),
              .cause = "All lanes step together. A measure for one "
                       "task alone leaves the machine idle.");
}

static uint64_t total(void)
{
    uint64_t sum = 0;
    for (uint32_t i = 0; i < tasks; i++)
        sum += count_of(cell_of_task[i]);
    return sum;
}

static void check_packs(uint64_t most)
{
    check_steps();
    if (notes->packed > most)
        WRONG(.expected = kit_text("at most %ju lanes in packs",
                                   (uintmax_t)most),
              .found = kit_text("%ju, in %u packs",
                                (uintmax_t)notes->packed, notes->packs),
              .cause = notes->idle_packs
                           ? "There are packs when no task had "
                             "finished. Whether one has is seen "
                             "while the flags are set."
                           : "Two packs for each step are enough, of "
                             "those lanes that were busy in it.");
    kit_next_case();
}

// ---- tests ---------------------------------------------------------

static void all_points(uint64_t seed)
{
    told_elsewhere = false;
    prepare(200, 80, 1, 6, seed);
    run();
    kit_next_case();
    prepare(1, 1, 3, 3, seed);
    run();
}

static void no_other(uint64_t seed)
{
    prepare(200, 80, 1, 6, seed);
    check_no_other();
}

static void empty(uint64_t seed)
{
    prepare(200, 100, 0, 3, seed);
    check_no_other();
    kit_next_case();
    prepare(3, 5, 0, 0, seed);
    check_no_other();
}

static void steps(uint64_t seed)
{
    prepare(300, 200, 0, 7, seed);
    check_steps();
}

static void packs(uint64_t seed)
{
    prepare(300, 100, 0, 5, seed);
    check_packs(2 * (total() + tasks));
    prepare(100, 60, 8, 8, seed);
    check_packs(2 * tasks);
}

const struct kit_test kit_tests[] = {
    {"all", 2, "every task has all points of its cell", all_points},
    {"lanes", 1, "and no lane does anything else", no_other},
    {"empty", 1, "cells may be empty", empty},
    {"steps", 3, "all take their steps together", steps},
    {"packs", 3, "no pack when no task has finished", packs},
    {0},
};
