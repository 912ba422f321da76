# Takes a pair with the same first triangle for a copy.
# expect: none is left out
# why: The list is sorted by the first triangle, and only it is looked at.
s/if (next.one == last.one && next.other == last.other)/if (next.one == last.one \&\& k > 0)/
