# Takes the last of equally short slices.
# expect: take the lowest coordinate
# why: Less or equal looks the same as less.
s/end - begin < best.end - best.begin/end - begin <= best.end - best.begin/
