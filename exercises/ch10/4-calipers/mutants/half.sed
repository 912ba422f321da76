# Stops after half of the sides.
# expect: what half of the sides find
# why: "Each pair is met from both of its ends", which is true of most.
s/i < n; i++/i < (n + 1) \/ 2; i++/
