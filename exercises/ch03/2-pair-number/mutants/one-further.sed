# j - i, but the first pair of a row has j = i + 1.
# expect: first pair of its row
# why: They count how far $j$ is from $i$, and the first pair is one away.
s/(j - i - 1)/(j - i)/
