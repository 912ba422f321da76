# It looks into a bin of which nothing can be less.
# expect: A bound stands where its bin begins
# why: The look is superfluous but harmless, as long as it is not counted.
s/if (x == bins->border\[k\])/if (0)/
