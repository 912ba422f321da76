# Takes two low ends that pass for a beginning.
# expect: Which two kinds of ends
# why: They have passed each other, so something must begin.
s/if (left.high && !right.high)/if (!right.high)/
