#!/bin/sh
# The points that are still on their way, in percent
# Counted from the escape times of a picture.
set -eu
width=480 limit=1024
[ -z "$FULL" ] || width=1920 limit=2048
"$BUILD/ch06/portrait" $width $limit | awk -v limit=$limit '
    /^#/ { print; next }
    !head { head = 1; print "name\tstep\tpercent"; next }
    { all += NF; for (i = 1; i <= NF; i++) ended[$i]++ }
    END {
        active = all
        for (step = 1; step <= limit; step++) {
            active -= ended[step - 1]
            if (step < shown) continue
            printf "after_%d\t%d\t%.4f\n", step, step, 100 * active / all
            shown = step + int(step / 8) + 1
        }
    }'
