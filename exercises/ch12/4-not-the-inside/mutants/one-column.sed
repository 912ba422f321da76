# Forgets that a row may have one cell.
# expect: or twice
# why: In the drawing all blocks are wide.
s/            last - first < 2) {/            last < first) {/
