# The largest value allowed lands behind the last bin.
# expect: touches element 10 of counts
s/if (b > bins - 1)/if (0)/
