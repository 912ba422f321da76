# It makes all four passes, whatever the keys are.
# expect: changes nothing
s/if (count\[b\]\[byte(key, b)\] < n) {/{/
