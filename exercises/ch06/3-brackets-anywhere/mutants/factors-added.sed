# The factors are added.
# expect: What is the factor of both
s/first.factor \* second.factor/first.factor + second.factor/
