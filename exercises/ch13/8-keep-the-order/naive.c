// Walks over the whole list until nothing is swapped.
// expect: 4 of 10
#include "exercise.h"

void repair(uint32_t ends)
{
    bool done = false;
    while (!done) {
        done = true;
        for (uint32_t place = 0; place + 1 < ends; place++) {
            if (in_order(place))
                continue;
            const struct end a = end_at(place), b = end_at(place + 1);
            if (a.high > b.high)
                meeting_begins(a.box, b.box);
            if (a.high < b.high)
                meeting_ends(a.box, b.box);
            swap_ends(place);
            done = false;
        }
    }
}
