# The result is copied to array 0.
# expect: copied once more
# why: They want the answer in the array where the question was.
s/return from;/for (uint32_t i = 0; from == 1 \&\& i < n; i++) put(0, i, get(1, i));\
return 0;/
