// Exercise: the earlier fall
#pragma once

enum first { BOTH, FIRST_P, FIRST_Q, NOT_SURE };

struct fall {
    double begin, end; // where a node is: begin > floor > end
};

// Which of the two reaches the floor first, or both at once; or
// NOT_SURE. Numbers are 0 or, without their signs, from 2^-100 to
// 2^100, and so are their differences.
enum first earlier(double floor, const struct fall *p,
                   const struct fall *q);
