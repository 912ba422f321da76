# The sides of the ring take the corners along.
# expect: belong to a row and to a column
# why: Four sides of a square, each with both of its ends.
s|bool whole = dy == -far .. dy == far;|bool whole = dy == -far \|\| dy == far; if (whole \&\& k > 0 \&\& x.back >= far \&\& n + 1 < 8 * k) cells[n++] = (struct cell){go(home.column, -far, grid->columns), go(home.row, dy, grid->rows)};|
