// Tests of tasks in the order of their lengths: the rounds that each
// was given, the lanes that worked for nothing, and the order.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

static uint32_t tasks, longest, *length;

// What the student's process leaves behind.
static uint32_t *done;  // the rounds of each task
static uint32_t *first; // the order of the first round
static struct notes {
    uint32_t rounds, most_rounds;
    bool bad_lanes, bad_task, twice;
    uint32_t lanes, task; // the last ones
    bool idle;
    uint32_t idle_round, idle_task; // the first one
    bool changed;
    uint32_t changed_round; // the first in which the order is another
    bool disordered;
    uint32_t left, right; // the first such neighbors
} * notes;

static void look_at_order(uint32_t left, uint32_t right)
{
    if (notes->disordered || length[left] != length[right] ||
        left < right)
        return;
    notes->disordered = true;
    notes->left = left;
    notes->right = right;
}

void make_round(uint32_t lanes, const uint32_t *task)
{
    if (lanes > tasks || notes->rounds == notes->most_rounds) {
        notes->bad_lanes = true;
        notes->lanes = lanes;
        kit_leave();
    }
    for (uint32_t l = 0; l < lanes; l++) {
        notes->task = task[l];
        notes->bad_task = task[l] >= tasks;
        if (notes->bad_task)
            kit_leave();
        if (done[task[l]] == length[task[l]] && !notes->idle) {
            notes->idle = true;
            notes->idle_round = notes->rounds;
            notes->idle_task = task[l];
        }
        done[task[l]]++;
        if (l > 0)
            look_at_order(task[l - 1], task[l]);
        if (notes->rounds == 0)
            first[l] = task[l];
        if (first[l] != task[l] && !notes->changed) {
            notes->changed = true;
            notes->changed_round = notes->rounds;
        }
    }
    notes->rounds++;
    notes->lanes = lanes;
}

// ---- inputs --------------------------------------------------------

static void prepare(uint32_t n, uint32_t most)
{
    tasks = n;
    longest = most;
    length = kit_input("length", n, sizeof *length);
}

// As many points as uniform ones leave in a cell, one on average.
static void prepare_cells(uint32_t n, uint64_t seed)
{
    struct random random = {seed};
    prepare(n, 0);
    memset(length, 0, n * sizeof *length);
    for (uint32_t i = 0; i < n; i++)
        length[random_bits(&random) % n]++;
    for (uint32_t i = 0; i < n; i++)
        longest = length[i] > longest ? length[i] : longest;
    kit_given("%u tasks of 0 to %u rounds", n, longest);
}

static void prepare_equal(uint32_t n, uint32_t rounds, uint32_t most)
{
    prepare(n, most);
    for (uint32_t i = 0; i < n; i++)
        length[i] = rounds;
    kit_given("%u tasks of %u rounds; longest is %u", n, rounds, most);
}

// ---- checks --------------------------------------------------------

static const char *tell_task(uint32_t task)
{
    return kit_text("task %u, of length %u", task, length[task]);
}

static const char *missing_cause(uint32_t task)
{
    if (notes->rounds == 0)
        return "No round was done at all.";
    if (notes->idle)
        return "In the same lanes were tasks that had finished: "
               "which end of the order do the longest have?";
    if (length[task] == longest)
        return "It is one of the longest. There are as many rounds as "
               "the longest task needs.";
    if (done[task] == 0)
        return "It was in no lane. Are all tasks placed, those of the "
               "same length side by side?";
    return "It left too early: in round b, counted from 0, all tasks "
           "longer than b are at work.";
}

static void run(void)
{
    uint32_t *order = kit_output("order", tasks, sizeof *order);
    uint32_t *places =
        kit_output("places", (size_t)longest + 1, sizeof *places);
    done = kit_output("the rounds", tasks, sizeof *done);
    memset(done, 0, tasks * sizeof *done);
    first = kit_output("the first order", tasks, sizeof *first);
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){.most_rounds = tasks * (longest + 2) + 9};
    CALL(STUDENT(work_off)(tasks, length, longest, order, places));
    if (notes->bad_lanes)
        WRONG(.expected =
                  kit_text("at most %u lanes, and an end", tasks),
              .found = kit_text("round %u, with %u lanes",
                                notes->rounds + 1, notes->lanes),
              .cause = "There cannot be more lanes at work than tasks, "
                       "nor more rounds than all tasks need together.");
    if (notes->bad_task)
        WRONG(.expected = kit_text("tasks 0 to %u", tasks - 1),
              .found = kit_text("task %u in round %u", notes->task,
                                notes->rounds + 1),
              .cause = "No task was placed there. The scan must give "
                       "every task a place of its own, from 0 on.");
    for (uint32_t i = 0; i < tasks; i++)
        if (done[i] < length[i])
            WRONG(.where = tell_task(i),
                  .expected = kit_text("%u rounds", length[i]),
                  .found = kit_text("%u", done[i]),
                  .cause = missing_cause(i));
}

static const char *idle_cause(void)
{
    if (notes->lanes == tasks)
        return "There are as many lanes in the last round as in the "
               "first. Let fewer work as tasks finish.";
    if (length[notes->idle_task] == notes->idle_round)
        return "In round b, counted from 0, only tasks longer than b "
               "are at work. Those without any rounds never are.";
    return "A task that has finished must not be in front of one that "
           "has not: the longest first.";
}

// There is no pack: the order is made once.
static void check_order(void)
{
    run();
    if (notes->changed)
        WRONG(.where = kit_text("round %u", notes->changed_round + 1),
              .expected = "the order of the first round, or the "
                          "beginning of it",
              .found = "another order",
              .cause =
                  "This counts only for an order that is made once. "
                  "To gather in each round the tasks that have work "
                  "left is a pack of all of them. Order them once, "
                  "so that fewer lanes are all it takes.");
}

static void check_idle(void)
{
    check_order();
    if (notes->idle)
        WRONG(.where = tell_task(notes->idle_task),
              .expected = "no round after that",
              .found = kit_text("at work in round %u",
                                notes->idle_round + 1),
              .cause = idle_cause());
}

static void check_rounds(void)
{
    uint32_t needed = 0;
    for (uint32_t i = 0; i < tasks; i++)
        needed = length[i] > needed ? length[i] : needed;
    check_order();
    if (notes->rounds > needed)
        WRONG(.expected = kit_text("%u rounds", needed),
              .found = kit_text("%u", notes->rounds),
              .cause = notes->rounds == longest
                           ? "The longest task may be shorter than "
                             "longest allows: a round of no lanes is a "
                             "round."
                           : "All tasks that have work left take a "
                             "round together.");
}

// ---- tests ---------------------------------------------------------

static void all_done(uint64_t seed)
{
    prepare_cells(500, seed);
    run();
    kit_next_case();
    prepare_equal(50, 7, 7);
    run();
}

static void none_idle(uint64_t seed)
{
    prepare_cells(500, seed);
    check_idle();
    kit_next_case();
    prepare_equal(50, 7, 12);
    check_idle();
}

static void rounds(uint64_t seed)
{
    prepare_cells(500, seed);
    check_rounds();
    kit_next_case();
    prepare_equal(50, 7, 12);
    check_rounds();
}

static void order(uint64_t seed)
{
    prepare_cells(500, seed);
    check_rounds();
    if (notes->disordered)
        WRONG(.where = kit_text("tasks %u and %u, both of %u rounds",
                                notes->left, notes->right,
                                length[notes->left]),
              .expected = "the lower number in the lane before",
              .found = "the higher one",
              .cause = "Place the tasks from the first to the last, "
                       "each at the front of what is left for its "
                       "length.");
}

static void nothing(uint64_t seed)
{
    (void)seed;
    prepare_equal(20, 0, 3);
    check_idle();
    check_rounds();
    kit_next_case();
    prepare_equal(20, 0, 0);
    check_idle();
    check_rounds();
    kit_next_case();
    prepare_equal(1, 1, 1);
    check_idle();
    check_rounds();
}

const struct kit_test kit_tests[] = {
    {"done", 2, "every task has its rounds", all_done},
    {"idle", 1, "no task works that has finished", none_idle},
    {"rounds", 4, "all take their rounds together", rounds},
    {"order", 2, "equally long ones stay in order", order},
    {"nothing", 1, "where there is little or nothing to do", nothing},
    {0},
};
