// The obvious way: axis after axis, until one fails.
// expect: 4 of 10
#include "exercise.h"

uint32_t find_meeting(struct boxes boxes, const struct box *box,
                      uint32_t *found)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < boxes.n; i++) {
        int k = 0;
        while (k < 3 && boxes.low[k][i] <= box->high[k] &&
               boxes.high[k][i] >= box->low[k])
            k++;
        if (k == 3)
            found[count++] = i;
    }
    return count;
}
