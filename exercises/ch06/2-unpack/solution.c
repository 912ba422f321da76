// The inverse of pack, in place: from the back, because no survivor
// moves to the front, and so nothing is overwritten before it has
// moved.
#include "exercise.h"

void unpack(uint32_t n, const uint8_t *keep)
{
    //- solution
    uint32_t left = 0;
    for (uint32_t i = 0; i < n; i++)
        left += keep[i];
    for (uint32_t i = n; i-- > 0;)
        if (keep[i])
            move(--left, i);
        else
            clear(i);
    //- starter
    // // Your turn. So far: from the front, over what is still needed.
    // uint32_t next = 0;
    // for (uint32_t i = 0; i < n; i++)
    //     if (keep[i])
    //         move(next++, i);
    //     else
    //         clear(i);
    //- end
}
