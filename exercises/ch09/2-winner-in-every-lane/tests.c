// Tests of a search with four lanes: answers, with ties anywhere, and
// how many measures they took.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

enum { POINTS = 60, QUESTIONS = 400, SPANS_MOST = 3 };

// A question brings its own distances.
static struct question {
    uint32_t n, spans, self;
    struct span span[SPANS_MOST];
    double distance2[POINTS];
    uint32_t index[POINTS];
} * questions;

static struct found *found;

// What the student's process leaves behind, for each question.
static struct notes {
    uint32_t measures;
    bool bad_place;
    uint32_t place; // of the last measure
} * notes;

static uint32_t asking;

struct lanes measure(uint32_t place)
{
    const struct question *q = &questions[asking];
    notes[asking].measures++;
    notes[asking].place = place;
    notes[asking].bad_place = place >= q->n;
    if (place >= q->n || notes[asking].measures > 9 * POINTS)
        kit_leave();
    struct lanes lanes;
    for (uint32_t l = 0; l < LANES; l++) {
        bool there = place + l < q->n;
        lanes.distance2[l] = there ? q->distance2[place + l] : NAN;
        lanes.index[l] = there ? q->index[place + l] : 0;
    }
    return lanes;
}

// ---- questions -----------------------------------------------------

static bool in_spans(const struct question *q, uint32_t place)
{
    for (uint32_t s = 0; s < q->spans; s++)
        if (place >= q->span[s].begin && place < q->span[s].end)
            return true;
    return false;
}

// The place of the nearest from one place up to another; n: none.
static uint32_t winner(const struct question *q, uint32_t begin,
                       uint32_t end, uint32_t self)
{
    uint32_t best = q->n;
    for (uint32_t s = begin; s < end; s++) {
        if (q->index[s] == self)
            continue;
        if (best == q->n || q->distance2[s] < q->distance2[best] ||
            (q->distance2[s] == q->distance2[best] &&
             q->index[s] < q->index[best]))
            best = s;
    }
    return best;
}

static void swap(struct question *q, uint32_t a, uint32_t b)
{
    const double distance2 = q->distance2[a];
    q->distance2[a] = q->distance2[b];
    q->distance2[b] = distance2;
    const uint32_t index = q->index[a];
    q->index[a] = q->index[b];
    q->index[b] = index;
}

// Indices in random order, distances of so many different values.
static void shuffle(struct question *q, uint32_t values,
                    struct random *random)
{
    for (uint32_t s = 0; s < q->n; s++) {
        q->index[s] = s;
        q->distance2[s] = random_bits(random) % values / 8.0;
    }
    for (uint32_t s = q->n; s > 1; s--) {
        uint32_t other = random_bits(random) % s;
        double distance2 = q->distance2[s - 1];
        swap(q, s - 1, other);
        q->distance2[other] = distance2;
    }
}

// The query is in one of the spans, and so is the nearest.
static void seat(struct question *q, struct random *random)
{
    const struct span *home = &q->span[random_bits(random) % q->spans];
    if (home->begin == home->end)
        home = &q->span[0];
    uint32_t length = home->end - home->begin;
    uint32_t place = home->begin + random_bits(random) % length;
    q->self = q->index[place];
    q->distance2[place] = 0;
    uint32_t best = winner(q, 0, q->n, q->self);
    if (best == q->n || in_spans(q, best))
        return;
    for (uint32_t s = 0; s < q->n; s++)
        if (in_spans(q, s) && q->index[s] != q->self) {
            swap(q, s, best);
            return;
        }
    q->n = q->spans = 1; // no other point there
}

// Cuts n places into spans and gaps. The first span is not empty, the
// last one may end where the points end.
static void cut(struct question *q, uint32_t unit,
                struct random *random)
{
    uint32_t place = 0;
    for (uint32_t s = 0; s < q->spans; s++) {
        uint32_t left = (q->n - place) / unit;
        uint32_t most = left < 16 / unit ? left : 16 / unit;
        uint32_t length = unit * (random_bits(random) % (most + 1));
        if (s == 0 && length == 0)
            length = unit;
        q->span[s] = (struct span){place, place + length};
        place += length;
        if (place < q->n)
            place += random_bits(random) %
                     (q->n - place < 6 ? q->n - place : 6);
    }
    if (random_bits(random) % 2)
        q->n = q->span[q->spans - 1].end;
}

// Questions over at most POINTS points, spans of multiples of a unit.
static void prepare(uint32_t spans, uint32_t unit, uint32_t values,
                    uint64_t seed)
{
    struct random random = {seed};
    questions = kit_input("questions", QUESTIONS, sizeof *questions);
    for (uint32_t k = 0; k < QUESTIONS; k++) {
        struct question *q = &questions[k];
        *q = (struct question){.n = POINTS, .spans = spans};
        cut(q, unit, &random);
        shuffle(q, values, &random);
        seat(q, &random);
    }
}

// ---- checks --------------------------------------------------------

static const char *tell_question(const struct question *q)
{
    const char *text =
        kit_text("the query has index %u of %u", q->self, q->n);
    for (uint32_t s = 0; s < q->spans; s++)
        text = kit_text("%s%s [%u, %u)", text,
                        s ? "," : "; spans of places", q->span[s].begin,
                        q->span[s].end);
    return text;
}

static uint32_t place_of(const struct question *q, uint32_t index)
{
    uint32_t place = 0;
    while (place < q->n && q->index[place] != index)
        place++;
    return place;
}

// The lane in which a place of a span is measured.
static uint32_t lane_of(const struct question *q, uint32_t place)
{
    for (uint32_t s = 0; s < q->spans; s++)
        if (place >= q->span[s].begin && place < q->span[s].end)
            return (place - q->span[s].begin) % LANES;
    return 0;
}

static const char *tell(const struct question *q, struct found answer)
{
    if (answer.nearest == NO_INDEX)
        return "none";
    uint32_t place = place_of(q, answer.nearest);
    if (place == q->n)
        return kit_text("point %u, which there is not", answer.nearest);
    return kit_text("point %u at place %u, squared distance %g",
                    answer.nearest, place, answer.nearest2);
}

static bool in_last_lanes(const struct question *q, uint32_t place)
{
    for (uint32_t s = 0; s < q->spans; s++) {
        uint32_t length = q->span[s].end - q->span[s].begin;
        if (place < q->span[s].end && place >= q->span[s].begin)
            return place >= q->span[s].end - length % LANES;
    }
    return false;
}

// Whether a lane has NAN, behind the last point.
static bool has_nan(const struct question *q, uint32_t lane)
{
    for (uint32_t s = 0; s < q->spans; s++)
        for (uint32_t place = q->span[s].begin; place < q->span[s].end;
             place += LANES)
            if (place + lane >= q->n)
                return true;
    return false;
}

static const char *wrong_cause(const struct question *q, uint32_t right,
                               struct found answer)
{
    uint32_t place = place_of(q, answer.nearest);
    if (isnan(answer.nearest2) ||
        (answer.nearest2 == INFINITY && answer.nearest != NO_INDEX))
        return "Behind the last point distances are NAN: compare "
               "whether the new one is less.";
    if (answer.nearest == q->self)
        return "This is the query itself.";
    if (right == q->n)
        return "There is no other point: NO_INDEX, at INFINITY.";
    if (place < q->n && answer.nearest2 != q->distance2[place])
        return "This is not the distance of that point. A distance and "
               "its index are kept or replaced together.";
    if (answer.nearest2 == q->distance2[right] && place < q->n &&
        lane_of(q, place) == lane_of(q, right))
        return "These tie, in the same lane. The places are in the "
               "order of the cells, so the first one found need not "
               "have the lowest index.";
    if (answer.nearest2 == q->distance2[right])
        return "These tie, in different lanes. At the end, compare the "
               "indices of lanes that tie.";
    if (in_last_lanes(q, right))
        return "It is one of the last of its span, which has not four "
               "points any more. What the other lanes measure is "
               "no nearer, so let them.";
    if (has_nan(q, lane_of(q, right)))
        return "Its lane had NAN later, of which nothing is true: "
               "compare "
               "whether the new one is less, not whether it is not "
               "greater.";
    return kit_text(
        "It was measured in lane %u. Does each lane keep its "
        "best from one span to the next, and do all take "
        "part in the end?",
        lane_of(q, right));
}

static void ask_all(void)
{
    for (asking = 0; asking < QUESTIONS; asking++) {
        const struct question *q = &questions[asking];
        found[asking] = STUDENT(search)(q->spans, q->span, q->self);
    }
}

static void check_measures(const struct question *q,
                           const struct notes *note)
{
    uint32_t needed = 0;
    for (uint32_t s = 0; s < q->spans; s++)
        needed +=
            (q->span[s].end - q->span[s].begin + LANES - 1) / LANES;
    if (note->measures > needed)
        WRONG(.where = tell_question(q),
              .expected = kit_text("at most %u measures", needed),
              .found = kit_text("%u", note->measures),
              .cause = note->measures >= 3 * needed
                           ? "Four points are measured at a time: the "
                             "next four are four places on."
                           : "A span of seven points takes two, and an "
                             "empty one none.");
}

// Right answers are not enough: four lanes need fewer measures than
// there are points, about a third.
static void check_lanes(void)
{
    uint64_t needed = 0, measures = 0;
    for (uint32_t k = 0; k < QUESTIONS; k++) {
        const struct question *q = &questions[k];
        for (uint32_t s = 0; s < q->spans; s++)
            needed +=
                (q->span[s].end - q->span[s].begin + LANES - 1) / LANES;
        measures += notes[k].measures;
    }
    if (measures > 2 * needed)
        WRONG(.expected =
                  kit_text("some %ju measures", (uintmax_t)needed),
              .found = kit_text("%ju", (uintmax_t)measures),
              .cause =
                  "The answers are right, but one lane found them. "
                  "Four points are measured at a time: let all "
                  "four count, and go on by four places.");
}

static void check(bool count)
{
    found = kit_output("answers", QUESTIONS, sizeof *found);
    notes = kit_output("the notes", QUESTIONS, sizeof *notes);
    for (uint32_t k = 0; k < QUESTIONS; k++) {
        notes[k] = (struct notes){0};
        found[k] = (struct found){NO_INDEX, INFINITY};
    }
    CALL(ask_all());
    for (uint32_t k = 0; k < QUESTIONS; k++) {
        const struct question *q = &questions[k];
        if (notes[k].bad_place)
            WRONG(.where = tell_question(q),
                  .expected = kit_text("a place below %u", q->n),
                  .found = kit_text("place %u", notes[k].place),
                  .cause = "No point is there. An empty span has no "
                           "first place.");
        uint32_t right = winner(q, 0, q->n, q->self);
        struct found answer = {NO_INDEX, INFINITY};
        if (right < q->n)
            answer =
                (struct found){q->index[right], q->distance2[right]};
        if (found[k].nearest != answer.nearest ||
            found[k].nearest2 != answer.nearest2)
            WRONG(.where = tell_question(q),
                  .expected = tell(q, answer),
                  .found = tell(q, found[k]),
                  .cause = wrong_cause(q, right, found[k]));
        if (count)
            check_measures(q, &notes[k]);
    }
}

// ---- tests ---------------------------------------------------------

static void fours(uint64_t seed)
{
    prepare(1, LANES, 1000000, seed);
    check(false);
    kit_next_case();
    prepare(3, LANES, 1000000, seed);
    check(false);
}

static void rest(uint64_t seed)
{
    prepare(3, 1, 1000000, seed);
    check(false);
    check_lanes();
}

static void ties(uint64_t seed)
{
    prepare(3, 1, 40, seed);
    check(false);
    check_lanes();
    kit_next_case();
    prepare(2, 1, 1, seed);
    check(false);
}

static void measures(uint64_t seed)
{
    prepare(3, 1, 1000, seed);
    check(true);
}

const struct kit_test kit_tests[] = {
    {"fours", 2, "spans of four, eight, twelve points", fours},
    {"rest", 2, "spans of any length, in four lanes", rest},
    {"ties", 3, "the lowest index, in four lanes", ties},
    {"measures", 3, "four points for each measure", measures},
    {0},
};
