# A line for every two points.
# expect: and no more
# why: They leave room, to be on the safe side.
s/line \* LINE/line * 2 * LINE/
