# It looks at every number below the bound.
# expect: known without a look
# why: They sum the bins before, and then check the numbers once more, to be safe.
s/below = bins->start\[k\]/below = 0/; s/s = bins->start\[k\];/s = 0;/; s/if (x == bins->border\[k\])/if (0)/
