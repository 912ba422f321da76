# Lets columns wrap around, but not rows.
# expect: the last row is beside the first
# why: They solve the columns, where the seam is visible in memory, and forget the rows.
s/uint32_t ny = .*/uint32_t ny = 1;/
/^    uint32_t ny/s/$/\n    y[0].first = row < reach ? 0 : row - reach;\n    y[0].last = grid->rows - 1 - row < reach ? grid->rows - 1 : row + reach;/
