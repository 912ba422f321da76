#!/bin/sh
# Instructions and branches of the steps of chapter 9, counted by a simulator, for each query
# Callgrind counts what a step does and all that it calls; its branch
# predictor is a simple one. It knows no AVX-512, so the program is
# compiled for AVX2. The rows after a step's say in which functions its
# instructions are, for the two first steps and for the batches. Where
# there is no valgrind, or another kind of processor, the committed
# table stands.
set -eu
points=${FULL:+100000}
points=${points:-10000}
committed() {
    echo "ch09-evidence: $1; the table is the committed one" >&2
    cat book/data/ch09-evidence.tsv
    exit 0
}
command -v valgrind >/dev/null 2>&1 || committed "there is no valgrind"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
${CC:-cc} -std=c17 -O3 -march=x86-64-v3 -ffp-contract=off -fopenmp \
    -D_GNU_SOURCE -Icode -o "$folder/steps" \
    code/ch09-row-spans/experiments/steps.c code/algorithms.c \
    code/ch*/[a-z]*.c code/common/[a-z]*.c -lm \
    2>"$folder/errors" || committed "the program does not compile for AVX2"
# Each step runs once to warm up, once on the clock, and once for the
# distances of each row of the table that it is counted for.
one() { # name function runs
    valgrind --tool=callgrind --branch-sim=yes --toggle-collect="$2" \
        --callgrind-out-file="$folder/out" "$folder/steps" "$points" 1 \
        >/dev/null 2>"$folder/log" || return 1
    awk -v name="$1" -v n="$(($3 * points))" '
        $1 == "events:" { for (k = 2; k <= NF; k++) at[$k] = k }
        $1 == "totals:" {
            printf "%s\t%.4g\t%.4g\t%.3g\n", name, $at["Ir"] / n,
                ($at["Bc"] + $at["Bi"]) / n, ($at["Bcm"] + $at["Bim"]) / n
        }' "$folder/out"
}
in_spans() { # name runs: of the step that was counted last
    callgrind_annotate --threshold=100 "$folder/out" |
        awk -v name="$1" -v n="$(($2 * points))" '
        function add(part) { gsub(",", "", $1); sum[part] += $1 }
        function row(part) {
            printf "%s_%s\t%.4g\tnan\tnan\n", name, part, sum[part] / n
        }
        /:compare_with_span \[/ { add("comparing") }
        /:compare_row \[/ { add("rows") }
        /:query_all_rows \[/ { add("block") }
        END { row("comparing"); row("rows"); row("block") }'
}
parts() {
    callgrind_annotate --threshold=100 "$folder/out" |
        awk -v n="$((3 * points))" '
        function add(name) { gsub(",", "", $1); sum[name] += $1 }
        /:nearest \[/ { add("kernel") }
        /:stag(e|ing_open) \[/ { add("staging") }
        /:staging_point_out \[/ { add("pointing") }
        /:answer_chunk \[/ { add("driver") }
        /:restore_order/ { add("restoring") }
        END { for (name in sum)
                  printf "%s\t%.4g\tnan\tnan\n", name, sum[name] / n }'
}
table() {
    echo "# machine: simulated by $(valgrind --version)"
    echo "# compiler: $(${CC:-cc} -dumpfullversion -dumpversion | head -1)"
    echo "# flags: -std=c17 -O3 -march=x86-64-v3 -ffp-contract=off -fopenmp"
    echo "# date: $(date '+%Y-%m-%d %H:%M')"
    printf 'name\tinstructions\tbranches\tmispredicted\n'
    one counted_spans by_spans 3 && in_spans spans 3 &&
        one counted_vectors by_vectors 5 && in_spans vectors 5 &&
        one counted_pruned by_pruning 3 &&
        one counted_four by_four 3 &&
        one counted_batches by_filter 3 && parts
}
table >"$folder/table" || committed "valgrind does not run here"
cat "$folder/table"
