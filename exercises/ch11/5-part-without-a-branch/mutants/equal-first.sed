# What is equal to the cut comes first.
# expect: less than the cut
# why: At most, or less: one of the two.
s/value\[number\] < cut/value[number] <= cut/
