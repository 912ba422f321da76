#!/bin/sh
# Instructions, branches and caches of one search, counted by a simulator, for each query
# The simulator is callgrind, whose branches and caches are cachegrind's.
# It counts what search_NAME does and all that it calls. Its first cache
# has 32 KiB, its last 1 MiB: what one core has to itself. It knows no
# AVX-512, so the program is compiled for AVX2. Where there is no
# valgrind, or another kind of processor, the committed table stands.
set -eu
points=102400
committed() {
    echo "ch04-evidence: $1; the table is the committed one" >&2
    cat book/data/ch04-evidence.tsv
    exit 0
}
command -v valgrind >/dev/null 2>&1 || committed "there is no valgrind"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
${CC:-cc} -std=c17 -O3 -march=x86-64-v3 -ffp-contract=off -fopenmp \
    -D_GNU_SOURCE -Icode -o "$folder/one_search" \
    code/ch04-cell-sort/experiments/one_search.c \
    code/ch04-cell-sort/experiments/bench.c \
    code/ch04-cell-sort/[a-z]*.c code/common/[a-z]*.c -lm \
    2>"$folder/errors" || committed "the program does not compile for AVX2"
one() { # name kind c way function
    valgrind --tool=callgrind --branch-sim=yes --cache-sim=yes \
        --I1=32768,8,64 --D1=32768,8,64 --LL=1048576,16,64 \
        --toggle-collect="$5" --callgrind-out-file="$folder/out" \
        "$folder/one_search" "$2" "$3" "$4" "$points" \
        >/dev/null 2>"$folder/log" || return 1
    awk -v name="$1" -v n="$points" '
        $1 == "events:" { for (k = 2; k <= NF; k++) at[$k] = k }
        $1 == "totals:" {
            printf "%s\t%d\t%.4g\t%.4g\t%.3g\t%.4g\t%.3g\t%.3g\n", name, n,
                $at["Ir"] / n, ($at["Bc"] + $at["Bi"]) / n,
                ($at["Bcm"] + $at["Bim"]) / n, $at["Dr"] / n,
                $at["D1mr"] / n, $at["DLmr"] / n
        }' "$folder/out"
}
table() {
    echo "# machine: simulated by $(valgrind --version), 32 KiB and 1 MiB of cache"
    echo "# compiler: $(${CC:-cc} -dumpfullversion -dumpversion | head -1)"
    echo "# flags: -std=c17 -O3 -march=x86-64-v3 -ffp-contract=off -fopenmp"
    echo "# date: $(date '+%Y-%m-%d %H:%M')"
    printf 'name\tqueries\tinstructions\tbranches\tmispredicted\treads\tmissed_first\tmissed_last\n'
    one counted_uniform uniform 4 sorted search_sorted &&
        one counted_lattice lattice 4 sorted search_sorted &&
        one counted_uniform_batches uniform 4 batches search_batches &&
        one counted_lattice_batches lattice 4 batches search_batches &&
        one counted_lists uniform 2 lists search_lists &&
        one counted_lists_in_order uniform 2 lists_in_order search_lists &&
        one counted_indices uniform 2 indices search_indices &&
        one counted_indices_in_order uniform 2 indices_in_order search_indices &&
        one counted_sorted uniform 2 sorted search_sorted
}
table >"$folder/table" || committed "valgrind does not run here"
cat "$folder/table"
