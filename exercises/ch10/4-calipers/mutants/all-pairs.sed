# Measures all pairs.
# expect: only those between the calipers
# why: It is always right.
/while (height/,+1d
s/keep(&best, i, k);/for (k = i; k < n; k++) keep(\&best, i, k);/
