// A new array from the system each time, and nothing is kept.
// expect: 4 of 10
#include "exercise.h"

void *take(size_t bytes)
{
    return fresh(bytes);
}

void *take_cleared(size_t bytes)
{
    return fresh(bytes);
}

size_t height(void)
{
    return 0;
}

void back_to(size_t height)
{
    (void)height;
}
