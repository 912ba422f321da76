# Takes the first of the lanes that tie.
# expect: in different lanes
# why: Lanes are compared from 0 to 3 with "<".
s/(d2 == found.nearest2 /(0 /
