# It grows on the first side that is not safe, not on the most dangerous one.
# expect: whose border is nearest of all
s/if (away(grid, block, side, x, y) < gap)/if (gap == INFINITY || gap * gap > best.nearest2)/
