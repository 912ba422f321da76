# The ones go to the front.
# expect: The ones come first
s/first = constant(n, n - ones.total)/first = constant(n, ones.total)/
s/choose(flags, add(first, ones.before), zeros)/choose(flags, ones.before, add(first, zeros))/
