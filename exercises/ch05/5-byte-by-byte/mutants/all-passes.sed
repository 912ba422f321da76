# It makes all four passes, whatever the keys are.
# expect: changes nothing
# why: Four bytes, four passes; that some of them change nothing is seen only by who counts.
s/if (count\[b\]\[byte(key, b)\] < n) {/{/
