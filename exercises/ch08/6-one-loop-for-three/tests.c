// Tests of the single loop: which points each task was compared with,
// when it was given its next cell, and how many rounds it took.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

enum { LONGEST_WAY = 12, SPARE = 4 };

static uint32_t tasks, points;
static uint32_t *start;
static struct way {
    uint32_t cells, cell[LONGEST_WAY];
} * ways;

// What the student's process leaves behind; measured has a row for each
// task, and a column for each point.
static uint8_t *measured;
static uint32_t *shown; // the cells of its way that a task knows of
static struct notes {
    uint32_t rounds, calls;
    uint64_t given;
    enum {
        NOTHING,
        BAD_LANES,
        BAD_TASK,
        BAD_PLACE,
        TOO_EARLY,
        TOO_FAR,
        TOO_OFTEN
    } fault;
    uint32_t lanes, task, place; // of the fault
    bool strayed;
    uint32_t stray_round, stray_task, stray_place; // of the first one
} * notes;

static uint32_t count_of(uint32_t cell)
{
    return start[cell + 1] - start[cell];
}

static uint64_t needed_cells(void)
{
    uint64_t sum = 0;
    for (uint32_t i = 0; i < tasks; i++)
        sum += ways[i].cells + 1;
    return sum;
}

// ---- the machine ---------------------------------------------------

static void fault(int kind, uint32_t lanes, uint32_t task,
                  uint32_t place)
{
    notes->fault = kind;
    notes->lanes = lanes;
    notes->task = task;
    notes->place = place;
    kit_leave();
}

static uint8_t *mark_of(uint32_t task, uint32_t place)
{
    return &measured[(size_t)task * points + place];
}

// The first place in the first cells of a task's way that it has not
// measured, or points.
static uint32_t not_measured(uint32_t task, uint32_t cells)
{
    for (uint32_t k = 0; k < cells; k++) {
        uint32_t cell = ways[task].cell[k];
        for (uint32_t p = start[cell]; p < start[cell + 1]; p++)
            if (*mark_of(task, p) == 0)
                return p;
    }
    return points;
}

void next_cell(uint32_t lanes, const uint32_t *task,
               const uint32_t *visited, uint32_t *cell)
{
    if (lanes < 1 || lanes > tasks)
        fault(BAD_LANES, lanes, 0, 0);
    notes->calls++;
    notes->given += lanes;
    if (notes->given > 100 * needed_cells())
        fault(TOO_OFTEN, lanes, task[0], 0);
    for (uint32_t l = 0; l < lanes; l++) {
        uint32_t i = task[l], k = visited[l];
        if (i >= tasks)
            fault(BAD_TASK, lanes, i, 0);
        if (k > shown[i] || k > ways[i].cells)
            fault(TOO_FAR, lanes, i, k);
        if (not_measured(i, k) < points)
            fault(TOO_EARLY, lanes, i, not_measured(i, k));
        cell[l] = k < ways[i].cells ? ways[i].cell[k] : NOWHERE;
        shown[i] = k < ways[i].cells ? k + 1 : k;
    }
}

static void note(uint32_t task, uint32_t place)
{
    uint8_t *mark = mark_of(task, place);
    *mark += *mark < 2;
    bool stray = shown[task] == 0 || *mark == 2;
    if (!stray) {
        uint32_t cell = ways[task].cell[shown[task] - 1];
        stray = place < start[cell] || place >= start[cell + 1];
    }
    if (notes->strayed || !stray)
        return;
    notes->strayed = true;
    notes->stray_round = notes->rounds;
    notes->stray_task = task;
    notes->stray_place = place;
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
    notes->rounds++;
}

// ---- inputs --------------------------------------------------------

// Cells of fewest to most points, ways of random cells, each at most
// once, and a few points at the end that are in no task's way.
static void prepare(uint32_t n, uint32_t cells, uint32_t fewest,
                    uint32_t most, uint64_t seed)
{
    struct random random = {seed};
    tasks = n, points = 0;
    start = kit_input("start", cells + 2, sizeof *start);
    for (uint32_t k = 0; k < cells; k++) {
        start[k] = points;
        points += fewest + random_bits(&random) % (most - fewest + 1);
    }
    start[cells] = points;
    start[cells + 1] = points += SPARE;
    ways = kit_input("ways", n, sizeof *ways);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t first = random_bits(&random) % cells;
        ways[i].cells = 1 + random_bits(&random) % LONGEST_WAY;
        for (uint32_t k = 0; k < ways[i].cells; k++)
            ways[i].cell[k] = (first + 7 * k) % cells;
    }
    kit_given("%u tasks with ways of 1 to %d cells, of %u to %u points",
              n, LONGEST_WAY, fewest, most);
}

static uint32_t points_of_way(uint32_t task)
{
    uint32_t sum = 0;
    for (uint32_t k = 0; k < ways[task].cells; k++)
        sum += count_of(ways[task].cell[k]);
    return sum;
}

static uint32_t most_points(void)
{
    uint32_t most = 0;
    for (uint32_t i = 0; i < tasks; i++)
        if (points_of_way(i) > most)
            most = points_of_way(i);
    return most;
}

// The points of the k-th cell on a task's way, or of the k-th that is
// not empty; 0 if there are not so many.
static uint32_t kth_count(uint32_t task, uint32_t k, bool skip_empty)
{
    for (uint32_t c = 0; c < ways[task].cells; c++) {
        uint32_t count = count_of(ways[task].cell[c]);
        if (skip_empty && count == 0)
            continue;
        if (k-- == 0)
            return count;
    }
    return 0;
}

// The rounds of nested loops: all wait for the fullest of the first
// cells, then of the second ones, and so on.
static uint32_t nested_rounds(bool skip_empty)
{
    uint32_t sum = 0;
    for (uint32_t k = 0; k < LONGEST_WAY; k++) {
        uint32_t most = 0;
        for (uint32_t i = 0; i < tasks; i++) {
            uint32_t count = kth_count(i, k, skip_empty);
            most = count > most ? count : most;
        }
        sum += most;
    }
    return sum;
}

static uint32_t longest_desert(void)
{
    uint32_t longest = 0;
    for (uint32_t i = 0; i < tasks; i++)
        for (uint32_t k = 0, empty = 0; k < ways[i].cells; k++) {
            empty = count_of(ways[i].cell[k]) == 0 ? empty + 1 : 0;
            longest = empty > longest ? empty : longest;
        }
    return longest;
}

// ---- checks --------------------------------------------------------

static const char *tell_cell(uint32_t task, uint32_t k)
{
    uint32_t cell = ways[task].cell[k];
    if (count_of(cell) == 0)
        return kit_text("task %u, cell %u of %u on its way: empty",
                        task, k + 1, ways[task].cells);
    return kit_text("task %u, cell %u of %u on its way: places %u to "
                    "%u",
                    task, k + 1, ways[task].cells, start[cell],
                    start[cell + 1] - 1);
}

static const char *tell_shown(uint32_t task)
{
    if (shown[task] == 0)
        return kit_text("task %u, which has been given no cell", task);
    return tell_cell(task, shown[task] - 1);
}

static void check_fault(void)
{
    switch (notes->fault) {
    case NOTHING:
        return;
    case BAD_LANES:
        WRONG(.expected = kit_text("1 to %u lanes", tasks),
              .found = kit_text("%u", notes->lanes),
              .cause = "Call the machine only if there is a lane at "
                       "work, and with those that are.");
    case BAD_TASK:
        WRONG(.expected = kit_text("tasks 0 to %u", tasks - 1),
              .found = kit_text("task %u", notes->task),
              .cause = "That lane has no task. Are there as many as "
                       "you say?");
    case BAD_PLACE:
        WRONG(.where = tell_shown(notes->task),
              .expected = kit_text("places below %u", points),
              .found = kit_text("place %u", notes->place),
              .cause = "A lane goes on and on. Where does its cell "
                       "end, and which lanes are packed away?");
    case TOO_EARLY:
        WRONG(.where = tell_shown(notes->task),
              .expected = kit_text("compared with place %u first",
                                   notes->place),
              .found = "is to be given its next cell",
              .cause =
                  "Only a task that has measured all points of its "
                  "cell goes on. If its lane has: do a lane's "
                  "task, place and end stay together?");
    case TOO_FAR:
        WRONG(.where = tell_shown(notes->task),
              .expected = kit_text("at most %u cells visited",
                                   shown[notes->task]),
              .found = kit_text("%u", notes->place),
              .cause = "Count a cell as visited when you are told it, "
                       "and NOWHERE not at all.");
    case TOO_OFTEN:
        WRONG(.where = tell_shown(notes->task), .expected = "an end",
              .found = "calls of next_cell without one",
              .cause = "After each answer that is a cell, the task has "
                       "visited one more. NOWHERE is the end.");
    }
}

static const char *missing_cause(uint32_t task)
{
    uint32_t known = shown[task];
    if (known == ways[task].cells)
        return "It has been told of the cell and did not finish it. Do "
               "a lane's task, place and end stay together?";
    if (known > 0 && count_of(ways[task].cell[known - 1]) == 0)
        return "An empty cell is not the end of the way. A task in one "
               "needs its next cell.";
    return kit_text(
        "It was never given what comes after cell %u of its way. "
        "Go on until the answer is NOWHERE.",
        known);
}

static uint32_t way_position(uint32_t task, uint32_t place)
{
    uint32_t k = 0;
    while (place < start[ways[task].cell[k]] ||
           place >= start[ways[task].cell[k] + 1])
        k++;
    return k;
}

static void run(void)
{
    measured =
        kit_output("the points measured", (size_t)tasks * points, 1);
    memset(measured, 0, (size_t)tasks * points);
    shown = kit_output("the cells shown", tasks, sizeof *shown);
    memset(shown, 0, tasks * sizeof *shown);
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){0};
    CALL(STUDENT(seek)(tasks, start));
    check_fault();
    for (uint32_t i = 0; i < tasks; i++) {
        uint32_t place = not_measured(i, ways[i].cells);
        if (place < points)
            WRONG(.where = tell_cell(i, way_position(i, place)),
                  .expected = kit_text("compared with place %u", place),
                  .found = "it never is", .cause = missing_cause(i));
    }
}

static const char *stray_cause(void)
{
    uint32_t task = notes->stray_task, place = notes->stray_place;
    if (*mark_of(task, place) == 2)
        return "It has been compared with this one before. Does every "
               "round take the next place?";
    for (uint32_t k = 0; k < ways[task].cells; k++)
        if (place == start[ways[task].cell[k] + 1])
            return "That is just behind a cell on its way: a cell ends "
                   "before start of the next one, and an empty one "
                   "before it begins.";
    return "Do a lane's task, place and end stay together when lanes "
           "are packed?";
}

static void check_lanes(void)
{
    run();
    if (notes->strayed)
        WRONG(.where = kit_text("task %u", notes->stray_task),
              .expected = "only points of the cells on its way, once "
                          "each",
              .found =
                  kit_text("place %u in round %u", notes->stray_place,
                           notes->stray_round + 1),
              .cause = stray_cause());
}

static void check_cells(void)
{
    uint64_t most_calls =
        (uint64_t)(1 + most_points()) * (1 + longest_desert());
    check_lanes();
    if (notes->given > needed_cells())
        WRONG(.expected =
                  kit_text("%ju lanes in calls of next_cell, one "
                           "for each cell and each NOWHERE",
                           (uintmax_t)needed_cells()),
              .found = kit_text("%ju", (uintmax_t)notes->given),
              .cause = "A task with a point left in its cell needs no "
                       "other, nor does one that was told NOWHERE.");
    if (notes->calls > most_calls)
        WRONG(.expected = kit_text(
                  "at most %ju calls of next_cell: before "
                  "each round one, and one for each empty cell "
                  "of the longest desert",
                  (uintmax_t)most_calls),
              .found = kit_text("%u", notes->calls),
              .cause =
                  "All tasks that need a cell before a round are in "
                  "one call.");
}

static void check_rounds(void)
{
    uint32_t most = most_points();
    check_lanes();
    const bool nested = notes->rounds == nested_rounds(false) ||
                        notes->rounds == nested_rounds(true);
    kit_bands(
        (double)notes->rounds / most,
        (struct kit_band[]){{1, 6}, {1.5, 3}, {0, 0}},
        (struct kit_fault){
            .expected = kit_text("%u rounds, the points on the longest "
                                 "way",
                                 most),
            .found = kit_text("%u", notes->rounds),
            .cause =
                nested ? "These are the rounds of nested loops: a task "
                         "that has finished its cell waits for all "
                         "others. Let it go on."
                       : "In every round all tasks that have work left "
                         "should measure."});
}

// ---- tests ---------------------------------------------------------

static void all_points(uint64_t seed)
{
    prepare(100, 60, 1, 4, seed);
    run();
    kit_next_case();
    prepare(1, 15, 1, 3, seed);
    run();
}

static void lanes(uint64_t seed)
{
    prepare(100, 60, 0, 3, seed);
    check_lanes();
    kit_next_case();
    prepare(STRIP, 300, 0, 1, seed);
    check_lanes();
}

static void cells_together(uint64_t seed)
{
    prepare(STRIP, 300, 0, 2, seed);
    check_cells();
    kit_next_case();
    prepare(20, 30, 0, 0, seed);
    check_cells();
}

static void rounds(uint64_t seed)
{
    prepare(STRIP, 200, 0, 4, seed);
    check_rounds();
}

const struct kit_test kit_tests[] = {
    {"all", 1, "every task measures all on its way", all_points},
    {"lanes", 1, "and no others, though cells are empty", lanes},
    {"cells", 2, "next_cell for lanes that need it, together",
     cells_together},
    {"rounds", 6, "no lane waits for another", rounds},
    {0},
};
