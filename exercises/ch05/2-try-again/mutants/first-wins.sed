# It takes for granted that the first of several stores stays.
# expect: Is each lane that reads another's number a loser
# why: On their own machine the last store stays, or the first, always, and they program what they saw.
s/read\[l\] != l/read[l] < l/
