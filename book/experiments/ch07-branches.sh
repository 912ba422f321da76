#!/bin/sh
# Instructions, branches and wrong guesses a point, of three searches
# (counted by valgrind, whose simple model guesses somewhat worse than a
# processor; without it the counts of the book are taken); and those of
# the spiral by the decision that is guessed
set -eu
if [ -z "$FULL" ] || [ "$(uname -m)" != x86_64 ] ||
    ! command -v valgrind >/dev/null; then
    exec cat book/data/ch07-branches.tsv
fi
n=20000
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
# The events of a callgrind file by what their source line decides.
by_decision='
function decision_of(text) {
    if (text ~ /s < start\[cell/) return "points"
    if (text ~ /j == query->self/) return "itself"
    if (text ~ /d2 (<|==) query->best2/) return "nearer"
    if (text ~ /margin \* margin > best2/) return "sides"
    if (text ~ /nearest == NO_INDEX\)|k <= last; k/) return "layers"
    return function_now == "layer" ? "cells" : "rest"
}
function read_source(file, k, text) {
    if (file in known) return
    known[file] = 1
    for (k = 1; (getline text < file) > 0; k++) {
        if (text ~ /^(INLINED|static|void)/) function_now = ""
        if (text ~ /visit_layer\(const/) function_now = "layer"
        decision[file ":" k] = decision_of(text)
    }
}
/^events:/ { for (k = 2; k <= NF; k++) at[$k] = k }
/^f[lie]=/ { file = substr($0, 4); read_source(file) }
/^calls=/ { getline; next }
/^[0-9]/ {
    d = decision[file ":" $1]
    if (d == "") d = "rest"
    ir[d] += $at["Ir"]; bc[d] += $at["Bc"]; bcm[d] += $at["Bcm"]
}
END {
    split("points itself nearer sides cells layers rest", order)
    for (k = 1; k <= 7; k++)
        printf "spiral_%s\t%d\t%.5g\t%.5g\t%.5g\n", order[k], n,
            ir[order[k]] / n, bc[order[k]] / n, bcm[order[k]] / n
}'
# For a processor that valgrind knows.
${CC:-gcc} -g -std=c17 -O3 -march=haswell -ffp-contract=off -fopenmp \
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
        --compress-strings=no --compress-pos=no \
        --toggle-collect="${search##*:}" \
        "$room/near" -n "$n" -a "${algorithm%:*}" -t 1 2>"$room/log" >/dev/null
    awk -v name="$name" -v n="$n" '/^events:/ {
            for (k = 2; k <= NF; k++) at[$k] = k }
        /^(summary|totals):/ && !done { done = 1
            printf "%s\t%d\t%.5g\t%.5g\t%.5g\n", name, n,
                $at["Ir"] / n, $at["Bc"] / n, $at["Bcm"] / n }' \
        "$room/out"
done
awk -v n="$n" "$by_decision" "$room/out"
