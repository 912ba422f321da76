# Takes the first of the lanes that tie.
# expect: in different lanes
s/(d2 == found.nearest2 /(0 /
