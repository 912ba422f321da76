# The wrong flag decides.
# expect: decided by what comes after
# why: The flag says "begins", and they take it for the beginning of the joined stretch.
s/right.begins ? right.total/left.begins ? right.total/
