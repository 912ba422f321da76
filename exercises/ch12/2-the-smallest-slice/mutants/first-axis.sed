# Takes the first coordinate.
# expect: Another coordinate has fewer
# why: The loop that compares was left for later.
s/if (best.axis < 0 || end - begin < best.end - best.begin)/if (best.axis < 0)/
