# Inserts one by one.
# expect: One by one, it takes 15
s/return k >= 4 \&\& /return k > 99999 \&\& /
