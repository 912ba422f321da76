# Stops at the last corner.
# expect: After it comes corner 0
# why: They think of an array, which ends.
s/while (height/while (k + 1 < n \&\& height/
