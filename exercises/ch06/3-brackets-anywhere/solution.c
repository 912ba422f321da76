// Two things that do not look like sums, made into such. A segment that
// begins on the right makes the left total irrelevant. A step after a
// step is a step.
#include "exercise.h"

struct stretch no_stretch(void)
{
    //- solution
    return (struct stretch){.begins = false, .total = 0};
    //- starter
    // return (struct stretch){.begins = true, .total = 0}; // your turn
    //- end
}

struct stretch join_stretches(struct stretch left, struct stretch right)
{
    //- solution
    return (struct stretch){
        .begins = left.begins || right.begins,
        .total = right.begins ? right.total : left.total + right.total,
    };
    //- starter
    // // Your turn. So far: good enough for the plain loop.
    // uint32_t sum = left.total + right.total;
    // return (struct stretch){
    //     .begins = right.begins,
    //     .total = right.begins ? right.total : sum,
    // };
    //- end
}

struct steps no_steps(void)
{
    //- solution
    return (struct steps){.factor = 1, .offset = 0};
    //- starter
    // return (struct steps){.factor = 0, .offset = 0}; // your turn
    //- end
}

struct steps join_steps(struct steps first, struct steps second)
{
    //- solution
    return (struct steps){
        .factor = first.factor * second.factor,
        .offset = second.factor * first.offset + second.offset,
    };
    //- starter
    // // Your turn. So far: the first steps are forgotten.
    // return second;
    //- end
}
