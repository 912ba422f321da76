# Goes on beyond the end of a row.
# expect: though in memory the next row follows
/if (at + reach >= count) {/,/^    }/d
