# Right in the plain loop only: the left flag is forgotten.
# expect: must remember it
# why: In the plain loop the right side is always a single element, and there it is right.
s/left.begins || right.begins/right.begins/
