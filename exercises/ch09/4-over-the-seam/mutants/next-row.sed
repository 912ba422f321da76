# Goes on beyond the end of a row.
# expect: though in memory the next row follows
# why: They let the stretch go on beyond the row, where in memory something does follow.
/if (at + reach >= count) {/,/^    }/d
