# Inserts one by one.
# expect: One by one, it takes 15
# why: It is the first solution, and right.
s/return k >= 4 \&\& /return k > 99999 \&\& /
