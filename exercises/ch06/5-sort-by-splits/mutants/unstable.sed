# The ones are dealt out from the end.
# expect: not stable
# why: Counting down from the end is a neat way to put the ones behind the zeros.
s/n - ones.total/n - 1/
s/add(first/subtract(first/
