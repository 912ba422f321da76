# Takes what is reached both ways twice.
# expect: leads to the same cell
s|reach >= count / 2|reach >= count|
