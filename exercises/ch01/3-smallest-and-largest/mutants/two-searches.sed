# Every value is compared with both: 2n - 2 comparisons.
# expect: Every value is compared with both
# why: It is the obvious way, and without a count nothing seems wrong with it.
/for (uint32_t i = n % 2/,/^    }/c\
for (uint32_t i = 1; i < n; i++) {\
    if (less(i, best.smallest)) best.smallest = i;\
    if (less(best.largest, i)) best.largest = i;\
}
