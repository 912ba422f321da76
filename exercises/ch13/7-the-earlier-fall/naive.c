// Divides, and doubts what differs by less than a millionth.
// expect: 3 of 10
#include "exercise.h"
#include <math.h>

enum first earlier(double floor, const struct fall *p,
                   const struct fall *q)
{
    const double of_p = (p->begin - floor) / (p->begin - p->end);
    const double of_q = (q->begin - floor) / (q->begin - q->end);
    if (fabs(of_p - of_q) <= 1e-6 * (of_p + of_q))
        return NOT_SURE;
    return of_p < of_q ? FIRST_P : FIRST_Q;
}
