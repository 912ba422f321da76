# Takes the further end of a cell, always.
# expect: between them
# why: In the plain geometry an end is always the furthest place, and one does not meet the exception in a drawing of a few cells.
/if (antipode >= k/,+1d
