// The plane's formula for both.
// expect: 4 of 10
#include "exercise.h"
#include <math.h>

double nearest2(struct box box, double x, double y)
{
    double dx = fmax(0, fmax(box.left - x, x - box.right));
    double dy = fmax(0, fmax(box.bottom - y, y - box.top));
    return dx * dx + dy * dy;
}

double nearest2_around(struct box box, double x, double y, double width,
                       double height)
{
    (void)width, (void)height;
    return nearest2(box, x, y);
}
