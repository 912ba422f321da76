# All threads add to one sum, without a guard.
# expect: lose updates
# why: A shared sum of the lefts is right with a reduction, and they leave the reduction out.
s/left\[t + 1\] = mine;/& lefts += mine;/
s/lefts = left\[all\];//
