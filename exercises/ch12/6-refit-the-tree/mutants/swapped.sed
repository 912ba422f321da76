# Takes the least on the left.
# expect: greatest is wanted on the left
# why: The names say left and right, not least and greatest.
s/left.high\[tree->axis\[node\]\]/left.low[tree->axis[node]]/
