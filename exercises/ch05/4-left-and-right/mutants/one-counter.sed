# All threads add to one sum, and nobody guards it.
# expect: lose updates
s/left\[t + 1\] = mine;/& lefts += mine;/
s/lefts = left\[all\];//
