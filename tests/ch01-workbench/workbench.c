// Chapter 1: the tools must be right before anything is measured.
#include "common/clock.h"
#include "harness.h"

static void quartiles_interpolate(void)
{
    double values[] = {4, 1, 3, 2};
    struct summary s = summarize(values, 4);
    CHECK_DOUBLE(1, s.min, "least");
    CHECK_DOUBLE(1.75, s.q1, "first quartile");
    CHECK_DOUBLE(2.5, s.median, "median");
    CHECK_DOUBLE(3.25, s.q3, "third quartile");
    CHECK_DOUBLE(4, s.max, "greatest");
}

int main(void)
{
    return RUN_TESTS("ch01-workbench", TEST(quartiles_interpolate));
}
