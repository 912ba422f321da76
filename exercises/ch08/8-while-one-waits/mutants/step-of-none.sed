# Gives a step to tasks that have none.
# expect: stays where it is
# why: The loop is a do-while, which makes a step before it asks.
s/lanes += steps\[t\] > 0/left[lanes] += steps[t] == 0; lanes++/
