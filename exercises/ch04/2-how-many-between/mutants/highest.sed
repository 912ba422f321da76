# The highest border is taken for a bound beyond all numbers.
# expect: A number that equals b was counted
# why: All other bins do not hold their upper border, and the exception is easily forgotten in one of the two places where it matters.
s/x > bins->border\[bins->count\]/x >= bins->border[bins->count]/
