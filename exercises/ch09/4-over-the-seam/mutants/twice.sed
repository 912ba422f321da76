# Takes what is reached both ways twice.
# expect: leads to the same cell
# why: On a small grid the way to the left and the way to the right end in the same cell.
s|reach >= count / 2|reach >= count|
