# Right in the plain loop only: the left flag is forgotten.
# expect: must remember it
s/left.begins || right.begins/right.begins/
