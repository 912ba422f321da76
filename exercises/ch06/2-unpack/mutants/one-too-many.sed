# Takes the value first and counts down afterwards.
# expect: Survivors are taken from one place too far
s/--left/left--/
