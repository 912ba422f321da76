# Takes the cut that is further from the middle.
# expect: nearer to the middle
# why: The comparison is easily turned around.
s/n - below <= up_to/n - below > up_to/
