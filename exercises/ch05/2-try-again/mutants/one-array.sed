# The lanes sign in the counts.
# expect: The lanes signed in the counts themselves
s/SCRATCH/COUNTS/
