// Tests of a layout: that no two numbers share a byte and all are in
// the memory, what four lanes load at once, and the lines that several
// programs fetch, counted.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

// All places, as the student's function gives them.
struct places {
    uint32_t n;
    size_t *at[2];
    size_t room; // bytes
};

static size_t lines_for(uint32_t n)
{
    return ((size_t)n * 2 * sizeof(double) + LINE - 1) / LINE;
}

static struct places ask(uint32_t n)
{
    struct places places = {
        n,
        {kit_output("the places", n, sizeof(size_t)),
         kit_output("the places", n, sizeof(size_t))},
        lines_for(n) * LINE};
    kit_given("%u points, a memory of %zu lines", n, lines_for(n));
    CALL(for (uint32_t i = 0; i < n; i++) {
        places.at[X][i] = STUDENT(place_of)(n, i, X);
        places.at[Y][i] = STUDENT(place_of)(n, i, Y);
    });
    return places;
}

static const char *tell(uint32_t i, int axis)
{
    return kit_text("%c of point %u", axis == X ? 'x' : 'y', i);
}

// Every number has eight bytes of the memory for itself.
static struct places check(uint32_t n)
{
    struct places places = ask(n);
    uint32_t *owner =
        kit_input("the owners", places.room, sizeof *owner);
    memset(owner, 0, places.room * sizeof *owner);
    for (uint32_t k = 0; k < 2 * n; k++) {
        uint32_t i = k / 2;
        size_t at = places.at[k % 2][i];
        if (at > places.room - sizeof(double))
            WRONG(.where = tell(i, k % 2),
                  .expected =
                      kit_text("a place before byte %zu", places.room),
                  .found = kit_text("byte %zu", at),
                  .cause = "The memory has room for two doubles a "
                           "point, rounded up to whole lines, and no "
                           "more. A place is counted in bytes.");
        if (at % sizeof(double) != 0)
            WRONG(.where = tell(i, k % 2),
                  .expected = "a multiple of 8",
                  .found = kit_text("byte %zu", at),
                  .cause = "A place is counted in bytes, and a double "
                           "has eight.");
        for (size_t byte = at; byte < at + sizeof(double); byte++) {
            if (owner[byte] != 0)
                WRONG(.where = tell(i, k % 2),
                      .expected = "a place of its own",
                      .found = kit_text("byte %zu, as for %s", at,
                                        tell((owner[byte] - 1) / 2,
                                             (owner[byte] - 1) % 2)),
                      .cause = "Two numbers stand in one place. What "
                               "must differ between the x and the y of "
                               "a point, and between two points?");
            owner[byte] = k + 1;
        }
    }
    return places;
}

static void own_places(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 4; n <= 400; n *= 10) {
        check(n);
        kit_next_case();
    }
}

static void odd_numbers(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 1; n <= 30; n++) {
        check(n);
        kit_next_case();
    }
}

// Four x, or four y, are loaded by one instruction.
static void check_vectors(struct places places)
{
    const uint32_t lanes = VECTOR / sizeof(double);
    for (uint32_t i = 0; i + lanes <= places.n; i += lanes)
        for (int axis = X; axis <= Y; axis++) {
            const size_t *at = places.at[axis] + i;
            if (at[0] % VECTOR != 0)
                WRONG(.where = tell(i, axis),
                      .expected = "a multiple of 32, where a vector "
                                  "may begin",
                      .found = kit_text("byte %zu", at[0]),
                      .cause = "A vector of four doubles is loaded "
                               "from a multiple of its length.");
            for (uint32_t lane = 1; lane < lanes; lane++)
                if (at[lane] != at[0] + lane * sizeof(double))
                    WRONG(.where = tell(i + lane, axis),
                          .expected =
                              kit_text("byte %zu, beside %s",
                                       at[0] + lane * sizeof(double),
                                       tell(i, axis)),
                          .found = kit_text("byte %zu", at[lane]),
                          .cause = "Four coordinates of one kind must "
                                   "lie side by side, or they have to "
                                   "be combed apart.");
        }
}

// Every line holds what it holds for both coordinates of its points.
static void check_lines(struct places places)
{
    for (uint32_t i = 0; i < places.n; i++) {
        size_t x = places.at[X][i] / LINE, y = places.at[Y][i] / LINE;
        if (x != y)
            WRONG(.where = kit_text("point %u", i),
                  .expected = "one line for both coordinates",
                  .found =
                      kit_text("x on line %zu, y on line %zu", x, y),
                  .cause =
                      "A program that wants one point here and one "
                      "there fetches two lines for each.");
    }
}

static void vectors(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 4; n <= 4000; n *= 10) {
        check_vectors(check(n));
        kit_next_case();
    }
}

static void one_line(uint64_t seed)
{
    (void)seed;
    struct places places = check(400);
    check_vectors(places);
    check_lines(places);
}

static void both(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 1; n <= 70; n++) {
        struct places places = check(n);
        check_vectors(places);
        check_lines(places);
        kit_next_case();
    }
}

const struct kit_test kit_tests[] = {
    {"own-places", 2, "every number has a place of its own",
     own_places},
    {"odd-numbers", 1, "for any number of points", odd_numbers},
    {"vectors", 1, "four x side by side, and four y", vectors},
    {"one-line", 3, "that, and each point on one line", one_line},
    {"both", 3, "all of it for any number of points", both},
    {0},
};
