# Cells are numbered column by column.
# expect: row by row
# why: Their mathematics writes x first.
s/cell_at(grid, points.x\[i\], points.y\[i\])/cell_at((struct grid){grid.rows, grid.columns}, points.y[i], points.x[i])/
