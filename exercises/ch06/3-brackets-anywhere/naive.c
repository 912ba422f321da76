// The plain loops as they stand, an element on the right.
// expect: 3 of 10
#include "exercise.h"

struct stretch no_stretch(void)
{
    return (struct stretch){false, 0};
}

struct stretch join_stretches(struct stretch left, struct stretch right)
{
    if (right.begins)
        return right;
    return (struct stretch){false, left.total + right.total};
}

struct steps no_steps(void)
{
    return (struct steps){1, 0};
}

struct steps join_steps(struct steps first, struct steps second)
{
    return (struct steps){second.factor * first.factor,
                          first.offset + second.offset};
}
