// The same loop over all pairs with the distance chosen by a pointer,
// by a flag and by a copy, once as the coursework has it and once over
// sixteen queries side by side. n distances a row, no indices.
#include "ch02-all-pairs/experiments/choices.h"
#include "ch02-all-pairs/first.h"

//> Search with the distance as a parameter
INLINED void loop(const struct question *question,
                  struct answers *answers, uint32_t begin, uint32_t end,
                  measure_function *measure)
{
    const struct points p = question->points;
    for (uint32_t i = begin; i < end; i++) {
        double near2 = INFINITY, far2 = 0, result[2];
        for (uint32_t j = 0; j < p.n; j++) {
            if (j == i)
                continue;
            measure(&question->space, p.x[j] - p.x[i], p.y[j] - p.y[i],
                    result);
            if (result[0] < near2)
                near2 = result[0];
            if (result[1] > far2)
                far2 = result[1];
        }
        answers->nearest2[i] = near2;
        answers->furthest2[i] = far2;
    }
}
//<

static measure_function *chosen(const struct question *question)
{
    return question->space.geometry == STANDARD ? measure_standard
                                                : measure_wraparound;
}

void pointer_rows(const struct question *question,
                  struct answers *answers, uint32_t begin, uint32_t end)
{
    loop(question, answers, begin, end, chosen(question));
}

//> Test the flag for every pair
static inline void in_either(const struct space *space, double dx,
                             double dy, double result[2])
{
    if (space->geometry == STANDARD)
        in_standard(space, dx, dy, result);
    else
        in_wraparound(space, dx, dy, result);
}
//<

void flag_rows(const struct question *question, struct answers *answers,
               uint32_t begin, uint32_t end)
{
    loop(question, answers, begin, end, in_either);
}

void copies_rows(const struct question *question,
                 struct answers *answers, uint32_t begin, uint32_t end)
{
    if (question->space.geometry == STANDARD)
        loop(question, answers, begin, end, in_standard);
    else
        loop(question, answers, begin, end, in_wraparound);
}

enum { QUERIES = 16 };

INLINED void lane_loop(const struct question *question,
                       struct answers *answers, uint32_t begin,
                       uint32_t end, measure_function *measure)
{
    const struct points p = question->points;
    for (uint32_t i = begin; i < end; i += QUERIES) {
        double x[QUERIES], y[QUERIES], near2[QUERIES], far2[QUERIES];
        for (int lane = 0; lane < QUERIES; lane++) {
            x[lane] = p.x[i + lane];
            y[lane] = p.y[i + lane];
            near2[lane] = INFINITY;
            far2[lane] = 0;
        }
        for (uint32_t j = 0; j < p.n; j++)
            for (int lane = 0; lane < QUERIES; lane++) {
                double result[2];
                measure(&question->space, p.x[j] - x[lane],
                        p.y[j] - y[lane], result);
                near2[lane] =
                    result[0] < near2[lane] ? result[0] : near2[lane];
                far2[lane] =
                    result[1] > far2[lane] ? result[1] : far2[lane];
            }
        for (int lane = 0; lane < QUERIES; lane++) {
            answers->nearest2[i + lane] = near2[lane];
            answers->furthest2[i + lane] = far2[lane];
        }
    }
}

void pointer_lanes_rows(const struct question *question,
                        struct answers *answers, uint32_t begin,
                        uint32_t end)
{
    lane_loop(question, answers, begin, end, chosen(question));
}

void flag_lanes_rows(const struct question *question,
                     struct answers *answers, uint32_t begin,
                     uint32_t end)
{
    lane_loop(question, answers, begin, end, in_either);
}

void copies_lanes_rows(const struct question *question,
                       struct answers *answers, uint32_t begin,
                       uint32_t end)
{
    if (question->space.geometry == STANDARD)
        lane_loop(question, answers, begin, end, in_standard);
    else
        lane_loop(question, answers, begin, end, in_wraparound);
}
