# Asks of the two products only whether they were rounded.
# expect: only if nothing was rounded
# why: A fused multiply-add tells it in a line; of a difference it takes more.
# points: 7
/const bool exact = is_small_integer/,/are_small_integers(p)/c\
    const double of_p_rest = fma(p->begin - floor, floor - q->end, -of_p);\
    const double of_q_rest = fma(q->begin - floor, floor - p->end, -of_q);\
    const bool exact = of_p_rest == 0 \&\& of_q_rest == 0;
/^static bool is_small_integer/,/^}/d
/^static bool are_small_integers/,/^}/d
