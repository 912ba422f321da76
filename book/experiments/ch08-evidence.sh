#!/bin/sh
# Instructions, branches and wrong guesses a point, one by one and in step, by valgrind
# The processor that valgrind simulates guesses somewhat worse than a
# real one. Where valgrind is missing, the committed table stays.
set -eu
if [ "$(uname -m)" != x86_64 ] || ! command -v valgrind >/dev/null; then
    echo "valgrind is missing, or this is no x86-64" >&2
    exec cat book/data/ch08-evidence.tsv
fi
n=20000
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
trap 'exit 1' HUP INT TERM
# For a processor that valgrind knows: it has AVX2, and not AVX-512.
${CC:-gcc} -std=c17 -O3 -march=haswell -ffp-contract=off -fopenmp \
    -D_GNU_SOURCE -Icode -o "$room/near" \
    code/near/*.c code/*.c code/ch*/*.c code/common/*.c -lm
# What is counted depends on the compiler, not on the machine.
"$BUILD/ch07/expect" |
    sed -n '/^# \(compiler\|flags\|date\)/{s/-march=[^ ]*/-march=haswell/; s/ -Werror//; s/ *$//; p;}'
printf 'name\tn\tinstructions\tbranches\twrong\n'
count() { # name instruction-set algorithm function
    NEAR_ISA=$2 OMP_WAIT_POLICY=passive valgrind --tool=callgrind \
        --branch-sim=yes --callgrind-out-file="$room/out" \
        --toggle-collect="$4" \
        "$room/near" -n "$n" -a "$3" -t 1 >/dev/null 2>"$room/log" ||
        { cat "$room/log" >&2; exit 1; }
    awk -v name="$1" -v n="$n" '/^events:/ {
            for (k = 2; k <= NF; k++) at[$k] = k }
        /^(summary|totals):/ && !done { done = 1
            printf "%s\t%d\t%.5g\t%.5g\t%.5g\n", name, n,
                $at["Ir"] / n, $at["Bc"] / n, $at["Bcm"] / n }' \
        "$room/out"
}
count guesses_one_by_one avx2 spiral spiral
count guesses_fused_plain portable vector-spiral vector_spiral
count guesses_fused avx2 vector-spiral vector_spiral
