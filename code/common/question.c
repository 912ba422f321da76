//> Make room for answers
// See question.h.
#include "common/question.h"
#include "common/fail.h"
#include <stdlib.h>

struct answers answers_allocate(uint32_t n)
{
    return (struct answers){
        .nearest = allocate(n, sizeof(uint32_t)),
        .furthest = allocate(n, sizeof(uint32_t)),
        .nearest2 = allocate(n, sizeof(double)),
        .furthest2 = allocate(n, sizeof(double)),
    };
}

void answers_free(struct answers *answers)
{
    free(answers->nearest);
    free(answers->furthest);
    free(answers->nearest2);
    free(answers->furthest2);
    *answers = (struct answers){0};
}
//<
