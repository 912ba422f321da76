# Takes long steps.
# expect: how long are the sides
# why: The first steps of the loop are taken for special cases that do not matter.
s/for (uint32_t sum = 1;/for (uint32_t sum = room > 40 ? 20 : 3;/
