# The right flag is forgotten.
# expect: begins in the right stretch
s/left.begins || right.begins/left.begins/
