# The wrong flag decides.
# expect: decided by what comes after
s/right.begins ? right.total/left.begins ? right.total/
