# The second steps come first.
# expect: The first steps come first
s/second.factor \* first.offset + second.offset/first.factor * second.offset + first.offset/
