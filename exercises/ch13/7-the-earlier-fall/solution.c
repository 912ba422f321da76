// Two products are compared, with a bound on six roundings.
#include "exercise.h"
#include <math.h>
#include <stdbool.h>

//- solution
static bool is_small_integer(double x)
{
    return fabs(x) <= 0x1p25 && floor(x) == x;
}

static bool are_small_integers(const struct fall *f)
{
    return is_small_integer(f->begin) && is_small_integer(f->end);
}

//- starter
//- end
enum first earlier(double floor, const struct fall *p,
                   const struct fall *q)
{
    //- solution
    const double of_p = (p->begin - floor) * (floor - q->end);
    const double of_q = (q->begin - floor) * (floor - p->end);
    const bool exact = is_small_integer(floor) &&
                       are_small_integers(p) && are_small_integers(q);
    // Three roundings in each product, and one for higher orders.
    const double doubt = exact ? 0 : 4 * 0x1p-53 * (of_p + of_q);
    if (fabs(of_p - of_q) > doubt)
        return of_p < of_q ? FIRST_P : FIRST_Q;
    return exact ? BOTH : NOT_SURE;
    //- starter
    // // Your turn: so far the lower one is first, however fast it is.
    // const double of_p = p->begin - floor, of_q = q->begin - floor;
    // if (of_p == of_q)
    //     return BOTH;
    // return of_p < of_q ? FIRST_P : FIRST_Q;
    //- end
}
