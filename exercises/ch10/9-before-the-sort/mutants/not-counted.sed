# Returns one too few.
# expect: thrown away
# why: The last index is taken for the number of them.
s/return count;/return count > 1 ? count - 1 : count;/
