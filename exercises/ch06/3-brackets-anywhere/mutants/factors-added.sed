# The factors are added.
# expect: What is the factor of both
# why: The offsets add, more or less, so the factors seem to, as well.
s/first.factor \* second.factor/first.factor + second.factor/
