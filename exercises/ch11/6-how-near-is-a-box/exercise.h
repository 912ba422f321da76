// Exercise: how near is a box?
#pragma once

struct box {
    double left, right, bottom, top;
};

// The least squared distance between (x, y) and a place in the box,
// border included.
double nearest2(struct box box, double x, double y);

// The same if all repeats after a period: the box and the place lie in
// one period of this width and height, and every separation d along an
// axis counts as the period less d, if that is less.
double nearest2_around(struct box box, double x, double y, double width,
                       double height);
