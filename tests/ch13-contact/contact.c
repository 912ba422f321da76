// Contact detection.
#include "narrow.h"
#include "parts.h"

int main(void)
{
    return RUN_TESTS("ch13-contact", NARROW_TESTS, BROAD_TESTS,
                     STEP_TESTS, SLEEP_TESTS);
}
