# The second steps come first.
# expect: The first steps come first
# why: Composition is written from the right in mathematics and from the left in time.
s/second.factor \* first.offset + second.offset/first.factor * second.offset + first.offset/
