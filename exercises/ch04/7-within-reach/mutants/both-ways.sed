# Half a block is searched, but every pair in it from both sides.
# expect: twice as many
s/try(i, j, r);/&/; s/if (measure(i, j) < r \* r)/if (measure(i, j) + 0 * measure(j, i) < r * r)/
