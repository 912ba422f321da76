//> Begin with the coursework's program
// The coursework's search, which calls the distance through a pointer
// for every pair and takes both results from an array, and four
// distances to be passed to it.
#include "ch02-all-pairs/first.h"

//> Let a pointer point at them
void measure_standard(const struct space *space, double dx, double dy,
                      double result[2])
{
    in_standard(space, dx, dy, result);
}

void measure_wraparound(const struct space *space, double dx, double dy,
                        double result[2])
{
    in_wraparound(space, dx, dy, result);
}
//<

//> Square with pow
void measure_pow(const struct space *space, double dx, double dy,
                 double result[2])
{
    (void)space;
    result[0] = result[1] = pow(dx, 2.0) + pow(dy, 2.0);
}
//<

//> Square with an exponent out of sight
static volatile double exponent = 2.0;

void measure_pow_variable(const struct space *space, double dx,
                          double dy, double result[2])
{
    (void)space;
    double e = exponent;
    result[0] = result[1] = pow(dx, e) + pow(dy, e);
}
//<

//> Search with a passed distance
void first_search(const struct question *question,
                  struct answers *answers, measure_function *measure,
                  uint32_t begin, uint32_t end)
{
    const struct points p = question->points;
    double result[2];
    for (uint32_t i = begin; i < end; i++) {
        uint32_t nearest = i == 0, furthest = i == 0;
        double nearest2 = INFINITY, furthest2 = 0;
        //> Call through the pointer for every candidate
        for (uint32_t j = 0; j < p.n; j++) {
            if (j == i)
                continue;
            measure(&question->space, p.x[j] - p.x[i], p.y[j] - p.y[i],
                    result);
            if (result[0] < nearest2) {
                nearest2 = result[0];
                nearest = j;
            }
            if (result[1] > furthest2) {
                furthest2 = result[1];
                furthest = j;
            }
        }
        //<
        //> Write the answers of a row down
        answers->nearest[i] = nearest;
        answers->nearest2[i] = nearest2;
        answers->furthest[i] = furthest;
        answers->furthest2[i] = furthest2;
        //<
    }
}
//<

//> Pass the distance of the geometry
void first_rows(const struct question *question,
                struct answers *answers, uint32_t begin, uint32_t end)
{
    first_search(question, answers,
                 question->space.geometry == STANDARD
                     ? measure_standard
                     : measure_wraparound,
                 begin, end);
}
//<
//<
