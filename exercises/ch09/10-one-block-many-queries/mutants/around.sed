# Takes one column more at the right edge.
# expect: a block has fewer columns
# why: In memory a row has no end, and the next one follows.
s/column + 1 < columns ? column + 1 : column;/column + 1 < columns || row + 2 < sorted->rows ? column + 1 : column;/
