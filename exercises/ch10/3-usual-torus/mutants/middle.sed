# Takes the distance of a cell's middle.
# expect: The middle of a cell
# why: Somebody thinks of a cell as of a point.
/return fmax(around/c\
    return around(k + 0.5 - x, n);
/if (antipode >= k/,+1d
