# Takes an empty cell for the end.
# expect: An empty cell is not the end
# why: No place after the call means finished, they think, and so does an empty cell.
/if (start\[cell\] == start\[cell + 1\])/,+1d
