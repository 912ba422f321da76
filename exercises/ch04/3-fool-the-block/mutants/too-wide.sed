# The fours of a row do not fit into the box.
# expect: It lies outside of the box
s|COLUMNS / 3|COLUMNS / 2|
