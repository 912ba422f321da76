// Tests of the two operations: elements joined from left to right, and
// with brackets anywhere, against the plain loops that they replace.
// Inside, both kinds of element are pairs of numbers.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <stdio.h>

enum { MOST = 200, SHOWN = 8, PROBES = 4, CASES_MOST = 40 };

struct pair {
    uint32_t a, b; // begins and total, or factor and offset
};
typedef struct pair join(struct pair left, struct pair right);

// ---- brackets ------------------------------------------------------

enum brackets { FROM_THE_LEFT, FROM_THE_RIGHT, ANYWHERE };
static const char *const bracket_names[] = {
    "from the left", "from the right", "anywhere"};

// Where, from first to end, the last join is.
static uint32_t middle(uint32_t first, uint32_t end,
                       enum brackets brackets, struct random *random)
{
    if (brackets == FROM_THE_LEFT)
        return end - 1;
    if (brackets == FROM_THE_RIGHT)
        return first + 1;
    return first + 1 + random_bits(random) % (end - first - 1);
}

static struct pair fold(const struct pair *elements, uint32_t first,
                        uint32_t end, enum brackets brackets,
                        struct random *random, join *join)
{
    if (end - first == 1)
        return elements[first];
    uint32_t cut = middle(first, end, brackets, random);
    struct pair left =
        fold(elements, first, cut, brackets, random, join);
    struct pair right =
        fold(elements, cut, end, brackets, random, join);
    return join(left, right);
}

static void write_brackets(FILE *to, uint32_t first, uint32_t end,
                           enum brackets brackets,
                           struct random *random)
{
    if (end - first == 1) {
        fprintf(to, "%u", first);
        return;
    }
    uint32_t cut = middle(first, end, brackets, random);
    fputc('(', to);
    write_brackets(to, first, cut, brackets, random);
    fputc(' ', to);
    write_brackets(to, cut, end, brackets, random);
    fputc(')', to);
}

static const char *tell_brackets(uint32_t n, enum brackets brackets,
                                 struct random random)
{
    if (n > SHOWN)
        return kit_text("%u elements, brackets %s", n,
                        bracket_names[brackets]);
    char text[20 * SHOWN];
    FILE *to = fmemopen(text, sizeof text, "w");
    write_brackets(to, 0, n, brackets, &random);
    fclose(to);
    return kit_text("elements %s", text);
}

// ---- what is joined, and what students make of it ------------------

static struct pair flag_of_right(struct pair left, struct pair right)
{
    return (struct pair){right.a, right.a ? right.b : left.b + right.b};
}

static struct pair flag_of_left(struct pair left, struct pair right)
{
    return (struct pair){left.a, right.a ? right.b : left.b + right.b};
}

static struct pair flag_of_both(struct pair left, struct pair right)
{
    return (struct pair){left.a && right.a,
                         right.a ? right.b : left.b + right.b};
}

static struct pair always_adds(struct pair left, struct pair right)
{
    return (struct pair){left.a || right.a, left.b + right.b};
}

static struct pair asks_left(struct pair left, struct pair right)
{
    return (struct pair){left.a || right.a,
                         left.a ? right.b : left.b + right.b};
}

static struct pair wrong_order(struct pair left, struct pair right)
{
    return (struct pair){left.a * right.a, left.a * right.b + left.b};
}

static struct pair adds_offsets(struct pair left, struct pair right)
{
    return (struct pair){left.a * right.a, left.b + right.b};
}

static struct pair adds_factors(struct pair left, struct pair right)
{
    return (struct pair){left.a + right.a, right.a * left.b + right.b};
}

static struct pair forgets(struct pair left, struct pair right)
{
    (void)left;
    return right;
}

struct mistake {
    join *join;
    const char *cause;
};

static const struct mistake stretch_mistakes[] = {
    {flag_of_right,
     "Enough for the plain loop, where the right stretch is a single "
     "element. Elsewhere a segment may begin in the left stretch, and "
     "the joined one must remember it."},
    {flag_of_left, "A segment that begins in the right stretch begins "
                   "in the joined one, too."},
    {flag_of_both,
     "One beginning is enough, wherever it is: or, not and."},
    {always_adds, "Where a segment begins, the total starts again. "
                  "What was before does not count."},
    {asks_left, "Whether the left total still counts is decided by "
                "what comes after it, in the right stretch."},
    {NULL, "Take two stretches of several elements on paper. Which of "
           "the four numbers does the joined total depend on?"},
};

static const struct mistake step_mistakes[] = {
    {wrong_order, "The first steps come first: put what they make of x "
                  "into the second ones."},
    {adds_offsets, "The first offset is there when the second steps "
                   "begin, and is multiplied as x is."},
    {adds_factors, "x is multiplied by one factor and then by the "
                   "other. What is the factor of both?"},
    {forgets, "The first steps are forgotten."},
    {NULL, "Write second(first(x)) out, and sort it by what is "
           "multiplied by x and what is not."},
};

// ---- calling the student -------------------------------------------

static struct stretch (*their_stretches)(struct stretch left,
                                         struct stretch right);
static struct steps (*their_steps)(struct steps first,
                                   struct steps second);

static struct pair student_stretches(struct pair left,
                                     struct pair right)
{
    struct stretch joined =
        their_stretches((struct stretch){left.a, left.b},
                        (struct stretch){right.a, right.b});
    return (struct pair){joined.begins, joined.total};
}

static struct pair student_steps(struct pair left, struct pair right)
{
    struct steps joined = their_steps((struct steps){left.a, left.b},
                                      (struct steps){right.a, right.b});
    return (struct pair){joined.factor, joined.offset};
}

static const struct kind {
    const char *name, *a, *b;
    struct pair probe[2];
    const struct mistake *mistakes;
    join *student;
} stretches = {.name = "stretches",
               .a = "begins",
               .b = "total",
               .probe = {{false, 7}, {true, 100}},
               .mistakes = stretch_mistakes,
               .student = student_stretches},
  steps = {.name = "steps",
           .a = "factor",
           .b = "offset",
           .probe = {{2, 3}, {5, 7}},
           .mistakes = step_mistakes,
           .student = student_steps};

static const char *tell(const struct kind *kind, struct pair pair)
{
    return kit_text("%s %u, %s %u", kind->a, pair.a, kind->b, pair.b);
}

static struct pair right_stretch(const struct pair *elements,
                                 uint32_t n)
{
    struct pair right = {false, 0};
    for (uint32_t i = 0; i < n; i++) {
        right.a |= elements[i].a;
        right.b =
            elements[i].a ? elements[i].b : right.b + elements[i].b;
    }
    return right;
}

// What the steps make of 0 and of 1 says what they are.
static struct pair right_steps(const struct pair *elements, uint32_t n)
{
    uint32_t of_0 = 0, of_1 = 1;
    for (uint32_t i = 0; i < n; i++) {
        of_0 = elements[i].a * of_0 + elements[i].b;
        of_1 = elements[i].a * of_1 + elements[i].b;
    }
    return (struct pair){of_1 - of_0, of_0};
}

static bool same(struct pair p, struct pair q)
{
    return p.a == q.a && p.b == q.b;
}

// Each of two elements joined to each.
static void probe(const struct kind *kind, join *join,
                  struct pair *results)
{
    for (int p = 0; p < PROBES; p++)
        results[p] = join(kind->probe[p / 2], kind->probe[p % 2]);
}

static const char *cause(const struct kind *kind,
                         const struct pair *results)
{
    const struct mistake *mistake = kind->mistakes;
    for (; mistake->join; mistake++) {
        struct pair wrong[PROBES];
        probe(kind, mistake->join, wrong);
        int p = 0;
        while (p < PROBES && same(results[p], wrong[p]))
            p++;
        if (p == PROBES)
            break;
    }
    return mistake->cause;
}

// Several cases, which are put into one call.
static struct one_case {
    char given[40];
    uint32_t n;
    struct pair elements[MOST];
    struct random random;
} cases[CASES_MOST];

static void check_case(const struct kind *kind,
                       const struct one_case *one,
                       enum brackets brackets, struct pair found,
                       const struct pair *probes)
{
    struct pair right = kind == &steps
                            ? right_steps(one->elements, one->n)
                            : right_stretch(one->elements, one->n);
    // The plain loop does not ask for the flag.
    if (kind == &stretches && brackets == FROM_THE_LEFT)
        right.a = found.a;
    if (!same(found, right))
        WRONG(.where = tell_brackets(one->n, brackets, one->random),
              .expected = tell(kind, right), .found = tell(kind, found),
              .cause = cause(kind, probes));
}

static void check(const struct kind *kind, int count,
                  enum brackets brackets)
{
    struct pair *found =
        kit_output("the answer", CASES_MOST, sizeof *found);
    struct pair *probes = kit_output("probes", PROBES, sizeof *probes);
    CALL(their_stretches = STUDENT(join_stretches);
         their_steps = STUDENT(join_steps);
         probe(kind, kind->student, probes);
         for (int c = 0; c < count; c++) {
             const struct one_case *one = &cases[c];
             struct random again = one->random;
             kit_given("%s", one->given);
             found[c] = fold(one->elements, 0, one->n, brackets, &again,
                             kind->student);
             check_case(kind, one, brackets, found[c], probes);
         });
    for (int c = 0; c < count; c++) {
        kit_given("%s", cases[c].given);
        check_case(kind, &cases[c], brackets, found[c], probes);
    }
    kit_next_case();
}

static void check_many(const struct kind *kind, enum brackets brackets,
                       uint64_t seed)
{
    struct random random = {seed};
    int count = 0;
    for (uint32_t n = 2; n <= MOST; n += 1 + n / 8) {
        struct one_case *one = &cases[count++];
        int one_in = 1 + n / 4;
        for (uint32_t i = 0; i < n; i++) {
            one->elements[i] =
                (struct pair){2 + random_bits(&random) % 8,
                              1 + random_bits(&random) % 99};
            if (kind == &stretches)
                one->elements[i].a = random_bits(&random) % one_in == 0;
        }
        one->n = n;
        one->random = random;
        snprintf(one->given, sizeof one->given, "%u %s", n, kind->name);
    }
    check(kind, count, brackets);
}

static void stretches_loop(uint64_t seed)
{
    check_many(&stretches, FROM_THE_LEFT, seed);
}

static void stretches_anywhere(uint64_t seed)
{
    for (uint64_t s = 0; s < 20; s++)
        check_many(&stretches, ANYWHERE, 20 * seed + s);
    check_many(&stretches, FROM_THE_RIGHT, seed);
}

static void steps_loop(uint64_t seed)
{
    check_many(&steps, FROM_THE_LEFT, seed);
}

static void steps_anywhere(uint64_t seed)
{
    for (uint64_t s = 0; s < 20; s++)
        check_many(&steps, ANYWHERE, 20 * seed + s);
    check_many(&steps, FROM_THE_RIGHT, seed);
}

// ---- nothing -------------------------------------------------------

static const char *nothing_cause(const struct kind *kind,
                                 struct pair nothing)
{
    if (kind == &stretches)
        return nothing.a ? "Where there are no elements, no segment "
                           "begins."
                         : "Where there are no elements, there is "
                           "nothing to add.";
    return nothing.a == 0 ? "With the factor 0, x is lost. No steps at "
                            "all leave x as it is."
                          : "No steps at all leave x as it is, "
                            "whatever it is.";
}

// What no elements should be, and what they do on either side.
static void check_nothing(const struct kind *kind, struct pair right)
{
    kit_given("no %s", kind->name);
    struct pair *found = kit_output("the answer", 1, sizeof *found);
    CALL(
        if (kind == &steps) {
            struct steps none = STUDENT(no_steps)();
            *found = (struct pair){none.factor, none.offset};
        } else {
            struct stretch none = STUDENT(no_stretch)();
            *found = (struct pair){none.begins, none.total};
        });
    if (!same(*found, right))
        WRONG(.expected = tell(kind, right),
              .found = tell(kind, *found),
              .cause = nothing_cause(kind, *found));
    kit_next_case();
    for (int c = 0; c < 4; c++) {
        const uint32_t a = c % 2;
        cases[c] =
            (struct one_case){.n = 2, .elements = {{a, 7}, {a, 7}}};
        cases[c].elements[c / 2] = right;
        snprintf(cases[c].given, sizeof cases[c].given,
                 "some %s and none", kind->name);
    }
    check(kind, 4, FROM_THE_LEFT);
}

static void no_stretches(uint64_t seed)
{
    (void)seed;
    check_nothing(&stretches, (struct pair){false, 0});
}

static void no_steps_at_all(uint64_t seed)
{
    (void)seed;
    check_nothing(&steps, (struct pair){1, 0});
}

const struct kit_test kit_tests[] = {
    {"loop", 1, "totals, joined from the left", stretches_loop},
    {"anywhere", 3, "stretches, brackets anywhere", stretches_anywhere},
    {"none", 1, "no stretch, beside others", no_stretches},
    {"steps-loop", 1, "steps, joined from the left", steps_loop},
    {"steps", 3, "steps, brackets anywhere", steps_anywhere},
    {"no-steps", 1, "no steps, beside others", no_steps_at_all},
    {0},
};
