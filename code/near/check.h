// Compares answers with a search of its own that looks at every pair in
// the plainest way and shares nothing with the algorithms but the
// distance. 2 n^2 distances.
#pragma once
#include "common/question.h"

// What was found wrong with one kind of neighbor: how many points, and
// the first of them.
struct verdict {
    uint32_t wrong, first;
};

struct verdicts {
    struct verdict nearest, furthest;
};

// An answer is right if its distance is the true one, to the last bit,
// and its neighbor another point at just that distance. Answers whose
// arrays are NULL are not looked at.
struct verdicts check_answers(const struct question *question,
                              const struct answers *answers);
