#!/bin/sh
# Thirty points, their nearest and furthest neighbors
#
# near names neighbors by number; the figure needs their coordinates.
set -eu
"$BUILD/near" -n 30 -s 4 -o - | awk -F '\t' -v OFS='\t' '
    NR == 1 { print "x", "y", "nx", "ny", "fx", "fy"; next }
    { x[$1] = $2; y[$1] = $3; nearest[$1] = $4; furthest[$1] = $6; n++ }
    END {
        for (i = 0; i < n; i++)
            print x[i], y[i], x[nearest[i]], y[nearest[i]],
                  x[furthest[i]], y[furthest[i]]
    }'
