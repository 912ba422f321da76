# The distance itself, not its square.
# expect: not its root
# why: "How far" is taken at its word.
s/nearest2\[l\] = best\[l\]/nearest2[l] = sqrt(best[l])/
