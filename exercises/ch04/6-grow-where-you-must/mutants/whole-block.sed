# It begins with the whole block of nine.
# expect: Begin with the query
# why: It is the block of the chapter, with the new rule added behind.
s/struct block block = {column, column, row, row};/struct block block = {column - (column > 0), column + (column + 1 < grid->columns), row - (row > 0), row + (row + 1 < grid->rows)};/
s/struct found best = look(column, row);/struct found best = {NO_INDEX, INFINITY}; for (uint32_t r = block.bottom; r <= block.top; r++) for (uint32_t c = block.left; c <= block.right; c++) best = better(best, look(c, r));/
