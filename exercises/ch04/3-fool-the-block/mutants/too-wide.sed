# The fours of a row do not fit into the box.
# expect: It lies outside of the box
# why: A hundred points are 25 fours, and 30 columns have room for ten side by side, not for all.
s|COLUMNS / 3|COLUMNS / 2|
