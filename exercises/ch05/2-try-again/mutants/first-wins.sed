# It takes for granted that the first of several stores stays.
# expect: Is each lane that reads another's number a loser
s/read\[l\] != l/read[l] < l/
