# Takes an empty cell for the end.
# expect: An empty cell is not the end
/if (start\[cell\] == start\[cell + 1\])/,+1d
