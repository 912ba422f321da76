# Puts all points anew.
# expect: look before you put
# why: It is the cell sort, with lists.
s/if (cell == NONE ||/if (cell != 0 || cell == NONE ||/
