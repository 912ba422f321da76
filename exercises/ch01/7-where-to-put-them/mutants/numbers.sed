# Places are counted in numbers, not in bytes.
# expect: a double has eight
# why: An index into an array of doubles counts doubles.
s/return \(line.*\);/return (\1) \/ sizeof(double);/
