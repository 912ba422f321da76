#!/bin/sh
# A small pile, drawn after 70 and after 300 steps: the triangles that
# face the eye of the figure, those with an event apart
set -e
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
printf 'frame\tx\ty\tz\tdark\n'
for steps in 70 300; do
    "$BUILD/contact" --scene pile -n 30 --steps "$steps" -t 1 \
        --pictures "$dir" -o /dev/null 2>"$dir/log"
    awk -v frame="$steps" '
        BEGIN { ex = 0.470; ey = -0.814; ez = 0.342 }
        NF == 3 { n++; x[n] = $1; y[n] = $2; z[n] = $3; next }
        n == 4 {
            ux = x[2] - x[1]; uy = y[2] - y[1]; uz = z[2] - z[1]
            vx = x[3] - x[1]; vy = y[3] - y[1]; vz = z[3] - z[1]
            side = (uy * vz - uz * vy) * ex + (uz * vx - ux * vz) * ey \
                 + (ux * vy - uy * vx) * ez
            if (side > 0)
                for (k = 1; k <= 4; k++)
                    if (k == 4) print ""
                    else printf "%d\t%.2f\t%.2f\t%.2f\t%d\n", frame, \
                        x[k], y[k], z[k], dark
        }
        n == 2 { dark = 1 }
        { n = 0 }' "$dir/step-$(printf %06d "$steps").dat"
done
