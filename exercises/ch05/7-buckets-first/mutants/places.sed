# The second round writes where the records stood, not their numbers.
# expect: Not all bits
# why: In the first round the number of the point and its place were one.
s/= records\[r\].point;/= r;/
