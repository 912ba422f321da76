# It grows on the first side that is not safe, not on the most dangerous one.
# expect: another side had to grow
# why: The condition is tested for each side in turn, and the first that fails grows; the answers are right.
s/if (away(grid, block, side, x, y) < gap)/if (gap == INFINITY || gap * gap > best.nearest2)/
