# The ones go to the front.
# expect: The ones come first
# why: A flag of 1 means "keep", in a pack, and what is kept goes to the front.
s/first = constant(n, n - ones.total)/first = constant(n, ones.total)/
s/choose(flags, add(first, ones.before), zeros)/choose(flags, ones.before, add(first, zeros))/
