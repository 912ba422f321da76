# The queries behind the last full group are forgotten.
# expect: a multiple of the lanes
# why: They tried numbers like 400 and 4,000, which are multiples of eight.
s/if (i == from.n)/if (i <= from.n)/
