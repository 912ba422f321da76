# The lanes sign in the counts.
# expect: The lanes signed in the counts themselves
# why: The printed figure of the report seems to say so, and it saves an array.
s/SCRATCH/COUNTS/
