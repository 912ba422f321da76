// Contact detection.
#include "narrow.h"

int main(void)
{
    return RUN_TESTS("ch13-contact", NARROW_TESTS);
}
