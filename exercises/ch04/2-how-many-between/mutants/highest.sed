# The highest border is taken for a bound beyond all numbers.
# expect: A number that equals b was counted
s/x > bins->border\[bins->count\]/x >= bins->border[bins->count]/
