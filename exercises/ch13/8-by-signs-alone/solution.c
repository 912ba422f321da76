// Three cases: on one side, one point in the plane, all in the plane.
#include "exercise.h"

//- solution
static const int NEXT[3] = {1, 2, 0};

// Whether a line along the segment or an edge has them apart.
static bool meet_in_plane(void)
{
    for (int k = 0; k < 3; k++)
        if (turn_of(k, NEXT[k], 3) < 0 && turn_of(k, NEXT[k], 4) < 0)
            return false;
    int sum = 0;
    for (int k = 0; k < 3; k++)
        sum += turn_of(3, 4, k);
    return sum != 3 && sum != -3;
}

// Whether the segment's line passes all edges in the same way.
static bool line_goes_through(void)
{
    bool left = false, right = false;
    for (int k = 0; k < 3; k++) {
        const int way = side_of(3, 4, k, NEXT[k]);
        left |= way > 0;
        right |= way < 0;
    }
    return !(left && right);
}
//- starter
//- end

bool segment_meets_triangle(void)
{
    const int begin = side_of(0, 1, 2, 3), end = side_of(0, 1, 2, 4);
    //- solution
    if (begin * end > 0)
        return false;
    if (begin == 0 && end == 0)
        return meet_in_plane();
    return line_goes_through();
    //- starter
    // // Your turn: so far it looks at the plane of the triangle only.
    // return begin * end <= 0;
    //- end
}
