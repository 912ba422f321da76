# Takes the other axis.
# expect: other axis
# why: Axis 0 is x, or was it y?
s/left.high\[tree->axis\[node\]\]/left.high[1 - tree->axis[node]]/
