# n / threads is rounded down.
# expect: the last points have no thread
# why: They try a thousand points on two, four and eight threads.
s/(uint64_t)n \* t \/ all/n \/ all * t/
s/(uint64_t)n \* (t + 1) \/ all/n \/ all * (t + 1)/
