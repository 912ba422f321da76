# The largest value allowed lands behind the last bin.
# expect: touches element 10 of counts
# why: The formula for the bin is right for every value below high, and high is the one value they did not try.
s/if (b > bins - 1)/if (0)/
