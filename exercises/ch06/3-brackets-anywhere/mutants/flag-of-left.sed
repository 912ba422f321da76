# The right flag is forgotten.
# expect: begins in the right stretch
# why: Whatever comes first is taken to decide whether something begins.
s/left.begins || right.begins/left.begins/
