# The ones are dealt out from the end.
# expect: not stable
s/n - ones.total/n - 1/
s/add(first/subtract(first/
