# Goes on beyond the end of a row.
# expect: though in memory the next row follows
/if (at + reach >= count) {/,/^    }/d
s/start\[x\[a\].last + 1\]/start[r * grid->columns + x[a].last + 1 > grid->columns * grid->rows ? grid->columns * (grid->rows - r) : x[a].last + 1]/
