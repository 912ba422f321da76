# Copies the block for each query anew, and lane by lane.
# expect: Find its spans once
# why: The search is written for one query and put into a loop over all.
/^    const double x = buffer->x\[q\]/i\
    for (uint32_t again = 0; again < 40; again++)\
        for (uint32_t c = 0; c < buffer->n; c++) {\
            buffer->y[c] = buffer->y[c] + 0.0;\
            __asm__ volatile("" ::: "memory");\
        }
