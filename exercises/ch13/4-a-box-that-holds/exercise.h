// Exercise: a box that holds
#pragma once

struct moving {
    double begin[3], end[3]; // from here to there, straight
};

struct float_box {
    float low[3], high[3];
};

// A box that holds all places which are no further than the reach,
// along each coordinate, from where the triangle is at some time.
// Coordinates are below 2^100 without their signs; the reach is from
// 2^-100 to 2^100.
struct float_box capture(const struct moving corner[3], double reach);
