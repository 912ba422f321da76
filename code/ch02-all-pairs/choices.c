//> Choose the geometry in three ways
// See choices.h.
#include "ch02-all-pairs/choices.h"
#include "ch02-all-pairs/first.h"

//> Pass the loop its distance
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

//> Choose by pointer
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
//<

//> Choose by flag
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
//<

//> Choose by copy
INLINED void copies(const enum geometry geometry,
                    const struct question *question,
                    struct answers *answers, uint32_t begin,
                    uint32_t end)
{
    loop(question, answers, begin, end,
         geometry == STANDARD ? in_standard : in_wraparound);
}

SPECIALIZE(copies)
//<

//> Pass a loop over lanes its distance
enum { ASKING = 16 };

INLINED void lane_loop(const struct question *question,
                       struct answers *answers, uint32_t begin,
                       uint32_t end, measure_function *measure)
{
    const struct points p = question->points;
    for (uint32_t i = begin; i < end; i += ASKING) {
        double x[ASKING], y[ASKING], near2[ASKING], far2[ASKING];
        for (int lane = 0; lane < ASKING; lane++) {
            x[lane] = p.x[i + lane];
            y[lane] = p.y[i + lane];
            near2[lane] = INFINITY;
            far2[lane] = 0;
        }
        for (uint32_t j = 0; j < p.n; j++)
            for (int lane = 0; lane < ASKING; lane++) {
                double result[2];
                measure(&question->space, p.x[j] - x[lane],
                        p.y[j] - y[lane], result);
                near2[lane] =
                    result[0] < near2[lane] ? result[0] : near2[lane];
                far2[lane] =
                    result[1] > far2[lane] ? result[1] : far2[lane];
            }
        for (int lane = 0; lane < ASKING; lane++) {
            answers->nearest2[i + lane] = near2[lane];
            answers->furthest2[i + lane] = far2[lane];
        }
    }
}
//<

//> Choose for lanes
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

INLINED void copies_lanes(const enum geometry geometry,
                          const struct question *question,
                          struct answers *answers, uint32_t begin,
                          uint32_t end)
{
    lane_loop(question, answers, begin, end,
              geometry == STANDARD ? in_standard : in_wraparound);
}

SPECIALIZE(copies_lanes)
//<
//<
