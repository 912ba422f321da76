# Takes the value first and counts down afterward.
# expect: Survivors are taken from one place too far
# why: "values[left--]" and "values[--left]" are told apart by trying.
s/--left/left--/
