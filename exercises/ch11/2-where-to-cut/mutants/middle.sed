# Cuts at the middle place, through equal numbers.
# expect: on both sides of the cut
# why: For different numbers, that is the median.
s/    if (below == 0)/    return n \/ 2;\n&/
