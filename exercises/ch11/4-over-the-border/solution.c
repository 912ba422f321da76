// Every point whose circle crosses the border walks up and down the
// other half from its own height.
#include "exercise.h"
#include <stdbool.h>

//- solution
// Whether something may be nearer to p at height y over the border.
static bool within(const struct halved *p, double border, double y)
{
    double dx = border - p->x, dy = y - p->y;
    return dx * dx + dy * dy < p->nearest2;
}

static void keep_less(struct halved *p, double d2)
{
    if (d2 < p->nearest2)
        p->nearest2 = d2;
}

//- starter
//- end
void join(struct halved *left, uint32_t lefts, struct halved *right,
          uint32_t rights, double border)
{
    //- solution
    uint32_t at = 0;
    for (uint32_t i = 0; i < lefts; i++) {
        struct halved *p = &left[i];
        while (at < rights && right[at].y < p->y)
            at++;
        for (uint32_t j = at; j < rights; j++) {
            if (!within(p, border, right[j].y))
                break;
            keep_less(p, measure(i, j));
        }
        for (uint32_t j = at; j-- > 0;) {
            if (!within(p, border, right[j].y))
                break;
            keep_less(p, measure(i, j));
        }
    }
    at = 0;
    for (uint32_t j = 0; j < rights; j++) {
        struct halved *q = &right[j];
        while (at < lefts && left[at].y < q->y)
            at++;
        for (uint32_t i = at; i < lefts; i++) {
            if (!within(q, border, left[i].y))
                break;
            keep_less(q, measure(i, j));
        }
        for (uint32_t i = at; i-- > 0;) {
            if (!within(q, border, left[i].y))
                break;
            keep_less(q, measure(i, j));
        }
    }
    //- starter
    // // Your turn: so far all of the left have one of the right.
    // (void)border;
    // for (uint32_t i = 0; i < lefts; i++) {
    //     double d2 = measure(i, rights / 2);
    //     if (d2 < left[i].nearest2)
    //         left[i].nearest2 = d2;
    //     if (d2 < right[rights / 2].nearest2)
    //         right[rights / 2].nearest2 = d2;
    // }
    //- end
}
