// Truths of a strip of boxes, and then a pack; no branch in either.
#include "exercise.h"

//- solution
enum { STRIP = 128 };

// For each box from first to end - 1: 1 if it meets, or else 0.
static void compare(struct boxes boxes, const struct box *box,
                    uint32_t first, uint32_t end, uint8_t *meets)
{
    const struct box b = *box;
    const double *low_x = boxes.low[0], *high_x = boxes.high[0];
    const double *low_y = boxes.low[1], *high_y = boxes.high[1];
    const double *low_z = boxes.low[2], *high_z = boxes.high[2];
    for (uint32_t i = first; i < end; i++)
        meets[i - first] =
            (low_x[i] <= b.high[0]) & (high_x[i] >= b.low[0]) &
            (low_y[i] <= b.high[1]) & (high_y[i] >= b.low[1]) &
            (low_z[i] <= b.high[2]) & (high_z[i] >= b.low[2]);
}

//- starter
//- end
uint32_t find_meeting(struct boxes boxes, const struct box *box,
                      uint32_t *found)
{
    uint32_t count = 0;
    //- solution
    uint8_t meets[STRIP];
    for (uint32_t first = 0; first < boxes.n; first += STRIP) {
        const uint32_t end =
            boxes.n - first < STRIP ? boxes.n : first + STRIP;
        compare(boxes, box, first, end, meets);
        for (uint32_t i = first; i < end; i++) {
            found[count] = i;
            count += meets[i - first];
        }
    }
    //- starter
    // // Your turn: so far it compares along the first axis.
    // for (uint32_t i = 0; i < boxes.n; i++)
    //     if (boxes.low[0][i] <= box->high[0] &&
    //         boxes.high[0][i] >= box->low[0])
    //         found[count++] = i;
    //- end
    return count;
}
