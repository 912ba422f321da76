#!/bin/sh
# Instructions, branches and wrong guesses a point, of three searches
# (counted by valgrind, whose simple model guesses somewhat worse than a
# processor; without it the counts of the book are taken)
set -eu
if [ -z "$FULL" ] || [ "$(uname -m)" != x86_64 ] ||
    ! command -v valgrind >/dev/null; then
    exec cat book/data/ch07-branches.tsv
fi
n=20000
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
# For a processor that valgrind knows.
${CC:-gcc} -std=c17 -O3 -march=haswell -ffp-contract=off -fopenmp \
    -D_GNU_SOURCE -Icode -o "$room/near" \
    code/near/*.c code/*.c code/ch*/*.c code/common/*.c -lm
"$BUILD/ch07/expect" | sed -n '/^#/{s/-march=[^ ]*/-march=haswell/; s/ -Werror//; p}'
printf 'name\tn\tinstructions\tbranches\twrong\n'
for search in blocks:cells-indices:cells_indices \
    together:cells:cells_batched spiral:spiral:spiral; do
    name=${search%%:*}
    algorithm=${search#*:}
    OMP_WAIT_POLICY=passive valgrind --tool=callgrind --branch-sim=yes \
        --callgrind-out-file="$room/out" \
        --toggle-collect="${search##*:}" \
        "$room/near" -n "$n" -a "${algorithm%:*}" -t 1 2>"$room/log" >/dev/null
    awk -v name="$name" -v n="$n" '/^events:/ {
            for (k = 2; k <= NF; k++) at[$k] = k }
        /^(summary|totals):/ && !done { done = 1
            printf "%s\t%d\t%.5g\t%.5g\t%.5g\n", name, n,
                $at["Ir"] / n, $at["Bc"] / n, $at["Bcm"] / n }' \
        "$room/out"
done
