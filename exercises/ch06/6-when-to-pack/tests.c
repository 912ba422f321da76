// Tests of the policy: what it costs, against the least that one
// could pay who knows the lifetimes, and against packs at the best
// fixed interval.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TASKS = 1000, TASKS_MOST = 1 << 16, LONGEST = 500, LIVES = 160 };

// alive_after[t]: how many tasks have work left after t steps.
static uint32_t alive_after[LONGEST + 1];
static uint32_t longest, price;

// What the student's process leaves behind.
static struct record {
    uint64_t cost, packs;
    uint32_t time, lanes, alive;
    bool step_too_many, pack_too_many;
} * record;

uint32_t step(void)
{
    if (record->alive == 0) {
        record->step_too_many = true;
        kit_leave();
    }
    record->cost += record->lanes;
    record->alive = alive_after[++record->time];
    return record->alive;
}

void pack(void)
{
    if (record->alive == 0) {
        record->pack_too_many = true;
        kit_leave();
    }
    record->cost += (uint64_t)price * record->lanes;
    record->packs++;
    record->lanes = record->alive;
}

// ---- lifetimes -----------------------------------------------------

static uint32_t uniform(uint32_t i, struct random *random)
{
    (void)i;
    return 1 + random_bits(random) % 200;
}

static uint32_t random_deaths(uint32_t i, struct random *random)
{
    (void)i;
    return 1 + -30 * log(1 - random_uniform(random));
}

static uint32_t heavy_tail(uint32_t i, struct random *random)
{
    (void)i;
    return 1 + 1 / (1 - random_uniform(random));
}

static uint32_t short_lives(uint32_t i, struct random *random)
{
    (void)i;
    return 1 + random_bits(random) % 4;
}

static uint32_t doubling(uint32_t i, struct random *random)
{
    (void)random;
    return 1 << i % 9;
}

static uint32_t two_classes(uint32_t i, struct random *random)
{
    (void)random;
    return i % 2 ? 200 : 10;
}

static uint32_t a_tenth(uint32_t i, struct random *random)
{
    (void)random;
    return i % 10 ? 500 : 1;
}

static uint32_t equal(uint32_t i, struct random *random)
{
    (void)i, (void)random;
    return 100;
}

static const struct family {
    const char *name;
    uint32_t (*lifetime)(uint32_t i, struct random *random);
} families[] = {
    {"uniform, 1 to 200 steps", uniform},
    {"random deaths, 30 steps on average", random_deaths},
    {"many short, a few very long", heavy_tail},
    {"1 to 4 steps", short_lives},
    {"1, 2, 4, ..., 256 steps", doubling},
    {"half 10 steps, half 200", two_classes},
    {"a tenth 1 step, the rest 500", a_tenth},
    {"100 steps each", equal},
};
enum { FAMILIES = sizeof families / sizeof *families };

static void count_alive(const uint32_t *lifetimes, uint32_t tasks)
{
    memset(alive_after, 0, sizeof alive_after);
    longest = 0;
    for (uint32_t i = 0; i < tasks; i++) {
        uint32_t life = lifetimes[i] < LONGEST ? lifetimes[i] : LONGEST;
        longest = life > longest ? life : longest;
        alive_after[life - 1]++;
    }
    for (uint32_t t = LONGEST; t-- > 0;)
        alive_after[t] += alive_after[t + 1];
}

static void set_family(const struct family *family, uint32_t tasks,
                       uint64_t seed)
{
    static uint32_t lifetimes[TASKS_MOST];
    struct random random = {seed};
    for (uint32_t i = 0; i < tasks; i++)
        lifetimes[i] = family->lifetime(i, &random);
    count_alive(lifetimes, tasks);
    kit_given("%u tasks, lifetimes: %s; price %u", tasks, family->name,
              price);
}

// ---- policies ------------------------------------------------------

// The least for one who knows the future: best[t] is the
// least for t steps if a pack follows them.
static uint64_t least_cost(void)
{
    uint64_t best[LONGEST + 1], least = UINT64_MAX;
    memset(best, 0xff, sizeof best);
    best[0] = 0;
    for (uint32_t s = 0; s < longest; s++) {
        uint64_t lanes = alive_after[s];
        uint64_t rest = best[s] + lanes * (longest - s);
        least = rest < least ? rest : least;
        for (uint32_t t = s + 1; t < longest; t++) {
            uint64_t cost = best[s] + lanes * (t - s + price);
            best[t] = cost < best[t] ? cost : best[t];
        }
    }
    return longest ? least : 0;
}

enum rule {
    INTERVAL,
    HALF,
    IDLE,
    IDLE_NEVER_RESET,
    IDLE_OLD_LANES,
    IDLE_32_BITS
};

static bool wants_pack(enum rule rule, uint32_t interval,
                       uint32_t since, uint32_t lanes, uint32_t alive,
                       uint64_t idle)
{
    switch (rule) {
    case INTERVAL:
        return since >= interval;
    case HALF:
        return alive < lanes / 2.0;
    case IDLE_32_BITS:
        return idle >= price * lanes;
    default:
        return idle >= (uint64_t)price * lanes;
    }
}

static uint64_t policy_cost(enum rule rule, uint32_t interval)
{
    uint32_t lanes = alive_after[0], since = 0;
    uint32_t seen = lanes; // the lanes that the policy knows of
    uint64_t cost = 0, idle = 0;
    for (uint32_t t = 0; t < longest; t++) {
        uint32_t alive = alive_after[t + 1];
        cost += lanes;
        idle += seen - alive;
        since++;
        if (alive == 0 ||
            !wants_pack(rule, interval, since, seen, alive, idle))
            continue;
        cost += (uint64_t)price * lanes;
        lanes = alive;
        since = 0;
        if (rule != IDLE_OLD_LANES)
            seen = alive;
        if (rule != IDLE_NEVER_RESET)
            idle = 0;
    }
    return cost;
}

static const char *cost_cause(uint64_t cost)
{
    if (record->packs == 0)
        return "There is no pack at all, and finished lanes step on "
               "with the others.";
    if (cost == policy_cost(INTERVAL, 1))
        return "There is a pack after every step. A pack costs as much "
               "as several steps.";
    if (price * alive_after[0] != (uint64_t)price * alive_after[0] &&
        cost == policy_cost(IDLE_32_BITS, 0))
        return "Price times lanes does not fit into 32 bits here: "
               "convert before you multiply.";
    if (cost == policy_cost(HALF, 0))
        return "A pack when less than half is alive: whether it pays "
               "depends on the price, and just under half of the lanes "
               "may be idle for ever.";
    if (cost == policy_cost(IDLE_NEVER_RESET, 0))
        return "What idle lanes have cost before the last pack is paid "
               "already: begin to count anew.";
    if (cost == policy_cost(IDLE_OLD_LANES, 0))
        return "After a pack there are fewer lanes, fewer of them are "
               "idle, and the next pack is cheaper.";
    for (uint32_t k = 2; k <= longest; k++)
        if (record->packs > 1 && cost == policy_cost(INTERVAL, k))
            return kit_text("There is a pack every %u steps, however "
                            "many lanes are idle.",
                            k);
    return "Compare two sums: what the idle lanes have cost since the "
           "last pack, and what the next pack costs.";
}

// ---- calling the student -------------------------------------------

static void begin(uint32_t tasks)
{
    *record = (struct record){.lanes = tasks, .alive = tasks};
}

static void check_end(void)
{
    if (record->step_too_many)
        WRONG(.where = kit_text("after %u steps", record->time),
              .expected = "no more steps", .found = "another step",
              .cause = "All tasks are finished: step only while there "
                       "is work. There may be none to begin with.");
    if (record->pack_too_many)
        WRONG(.where = kit_text("after %u steps", record->time),
              .expected = "the end", .found = "a pack",
              .cause = "All tasks are finished, and this pack is paid "
                       "for nothing.");
    if (record->alive > 0)
        WRONG(.where = kit_text("after %u steps", record->time),
              .expected = "all tasks finished",
              .found = kit_text("%u with work to do", record->alive),
              .cause = "Go on as long as step() says that there is "
                       "work.");
}

static void run(uint32_t tasks)
{
    record = kit_output("the record", 1, sizeof *record);
    begin(tasks);
    CALL(STUDENT(work_off)(tasks, price));
    check_end();
}

static void check_cost(uint64_t most, const char *means)
{
    if (record->cost > most)
        WRONG(.expected = kit_text("a cost of at most %ju, %s",
                                   (uintmax_t)most, means),
              .found = kit_text("%ju, with %ju packs",
                                (uintmax_t)record->cost,
                                (uintmax_t)record->packs),
              .cause = cost_cause(record->cost));
}

static void check_twice(uint32_t tasks)
{
    run(tasks);
    check_cost(2 * least_cost(), "twice the least possible");
    kit_next_case();
}

// All families, each with so many tasks.
static void check_families(uint32_t tasks, uint64_t seed)
{
    struct record *records =
        kit_output("the records", FAMILIES, sizeof *records);
    CALL(for (int f = 0; f < FAMILIES; f++) {
        set_family(&families[f], tasks, seed);
        record = &records[f];
        begin(tasks);
        STUDENT(work_off)(tasks, price);
        check_end();
    });
    for (int f = 0; f < FAMILIES; f++) {
        set_family(&families[f], tasks, seed);
        record = &records[f];
        check_end();
    }
    kit_next_case();
}

static void finished(uint64_t seed)
{
    price = 4;
    for (uint32_t tasks = 0; tasks <= 3; tasks++)
        check_families(tasks, seed);
    check_families(TASKS, seed);
}

static void usual(uint64_t seed)
{
    price = 4;
    for (int f = 0; f < 2; f++) {
        set_family(&families[f], TASKS, seed);
        run(TASKS);
        check_cost(1.25 * least_cost(), "a quarter more than the least "
                                        "possible");
        kit_next_case();
    }
}

static void interval(uint64_t seed)
{
    price = 4;
    for (int f = 4; f < 7; f++) {
        set_family(&families[f], TASKS, seed);
        uint64_t best = UINT64_MAX;
        for (uint32_t k = 1; k <= longest; k++) {
            uint64_t cost = policy_cost(INTERVAL, k);
            best = cost < best ? cost : best;
        }
        run(TASKS);
        check_cost(best, "as with the best fixed interval");
        kit_next_case();
    }
}

static void any_lifetimes(uint64_t seed)
{
    static const uint32_t prices[] = {1, 4, 20, 100};
    for (int p = 0; p < 4; p++)
        for (int f = 0; f < FAMILIES; f++) {
            price = prices[p];
            set_family(&families[f], TASKS, seed);
            check_twice(TASKS);
        }
    price = 1 << 16;
    set_family(&families[3], TASKS_MOST, seed);
    check_twice(TASKS_MOST);
}

// The one that hurts: all but one are finished after a step, and
// it is not known how long the one will last.
static void set_survivor(uint32_t life)
{
    static uint32_t lifetimes[TASKS];
    for (uint32_t i = 0; i < TASKS; i++)
        lifetimes[i] = i == 0 ? life : 1;
    count_alive(lifetimes, TASKS);
    kit_given("%d tasks, one of %u steps, the rest of 1; price %u",
              TASKS, life, price);
}

static void check_survivor(void)
{
    check_end();
    check_cost(2 * least_cost(), "twice the least possible");
}

static void one_survivor(uint64_t seed)
{
    (void)seed;
    price = 40;
    struct record *records =
        kit_output("the records", LIVES, sizeof *records);
    CALL(for (uint32_t life = 1; life <= LIVES; life++) {
        set_survivor(life);
        record = &records[life - 1];
        begin(TASKS);
        STUDENT(work_off)(TASKS, price);
        check_survivor();
    });
    for (uint32_t life = 1; life <= LIVES; life++) {
        set_survivor(life);
        record = &records[life - 1];
        check_survivor();
    }
}

const struct kit_test kit_tests[] = {
    {"finished", 2, "all is done, and then no more", finished},
    {"usual", 2, "near the least, for usual lifetimes", usual},
    {"interval", 2, "no dearer than the best interval", interval},
    {"any", 2, "at most twice the least, any price", any_lifetimes},
    {"survivor", 2, "the same with a single survivor", one_survivor},
    {0},
};
