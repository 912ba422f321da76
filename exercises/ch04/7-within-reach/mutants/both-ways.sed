# Half a block is searched, but every pair in it from both sides.
# expect: twice as many
# why: They take the right half of the block, and then every ordered pair in it.
s/try(i, j, r);/&/; s/if (measure(i, j) < r \* r)/if (measure(i, j) + 0 * measure(j, i) < r * r)/
