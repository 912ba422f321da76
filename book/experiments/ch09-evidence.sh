#!/bin/sh
# Instructions and branches of the steps of chapter 9, and cycles of its inner loops: counted, no time is measured
# Callgrind counts what a step does and all that it calls; its branch
# predictor is a simple one. It knows no AVX-512, so the program is
# compiled for AVX2. The rows after a step's say in which functions its
# instructions are, for the two first steps and for the batches. The
# rows loop_... are for one candidate in the inner loops of batches of
# four, of eight, and of eight in sixteen lanes: llvm-mca works out their
# cycles on its model of an Ice Lake, the oldest with AVX-512. Where a
# tool is missing, or on another kind of processor, the committed rows
# stand.
set -eu
points=100000
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
            printf "%s\t%.4g\t%.4g\t%.3g\tnan\n", name, $at["Ir"] / n,
                ($at["Bc"] + $at["Bi"]) / n, ($at["Bcm"] + $at["Bim"]) / n
        }' "$folder/out"
}
in_spans() { # name runs: of the step that was counted last
    callgrind_annotate --threshold=100 "$folder/out" |
        awk -v name="$1" -v n="$(($2 * points))" '
        function add(part) { gsub(",", "", $1); sum[part] += $1 }
        function row(part) {
            printf "%s_%s\t%.4g\tnan\tnan\tnan\n", name, part, sum[part] / n
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
        /:stage(_candidates)? \[/ { add("staging") }
        /:find_candidates \[/ { add("pointing") }
        /:answer_chunk \[/ { add("driver") }
        /:restore_order/ { add("restoring") }
        END { for (name in sum)
                  printf "%s\t%.4g\tnan\tnan\tnan\n", name, sum[name] / n }'
}
loop() { # name candidates source state call
    {
        echo "#include \"$3\""
        echo "void loop(const struct sorted *sorted,"
        echo "          const struct staging *staging, uint32_t from,"
        echo "          uint32_t to, struct $4 *state)"
        echo "{"
        echo "    struct space space = {0};"
        echo "    struct $4 mine = *state;"
        echo "    (void)space, (void)sorted, (void)staging;"
        echo "    $5;"
        echo "    *state = mine;"
        echo "}"
    } >"$folder/loop.c"
    ${CC:-cc} -std=c17 -O3 -march=icelake-server -ffp-contract=off \
        -fopenmp -D_GNU_SOURCE -Icode -S -o "$folder/loop.s" \
        "$folder/loop.c" 2>"$folder/errors" || return 1
    # An innermost loop is what stands between a label and a jump back.
    awk '/^loop:/ { inside = 1 }
        /^\.L[0-9]+:/ { label = $1; n = 0; next }
        inside && /^\t[a-z]/ { line[++n] = $0 }
        inside && $1 ~ /^j/ && $2 ":" == label {
            for (k = 1; k <= n; k++)
                print line[k]
            exit
        }' "$folder/loop.s" >"$folder/turn.s"
    "$mca" -mtriple=x86_64 -mcpu=icelake-server -iterations=1000 \
        "$folder/turn.s" | awk -v name="$1" -v n="$(($2 * 1000))" '
        /^Instructions:/ { instructions = $2 / n }
        /^Total Cycles:/ { cycles = $3 / n }
        END {
            printf "%s\t%.4g\tnan\tnan\t%.3g\n", name, instructions, cycles
        }'
}
loops() {
    mca=$(command -v llvm-mca-14 || command -v llvm-mca) ||
        { grep '^loop_' book/data/ch09-evidence.tsv; return; }
    loop loop_four 1 ch04-cell-sort/batches.c batch \
        'compare_stretch(STANDARD, space, sorted, from, to, &mine)' &&
        loop loop_eight 4 ch09-row-spans/avx2_spans.c lane_state \
            'sweep_span(measure_near, staging, from, to, &mine)' &&
        loop loop_sixteen 4 ch09-row-spans/avx512_spans.c wide_lanes \
            'sweep_span_wide(measure_near, staging, from, to, &mine)'
}
table() {
    echo "# machine: simulated by $(valgrind --version)"
    echo "# compiler: $(${CC:-cc} -dumpfullversion -dumpversion | head -1)"
    echo "# flags: -std=c17 -O3 -march=x86-64-v3 -ffp-contract=off -fopenmp"
    echo "# date: $(date '+%Y-%m-%d %H:%M')"
    printf 'name\tinstructions\tbranches\tmispredicted\tcycles\n'
    one counted_spans by_spans 3 && in_spans spans 3 &&
        one counted_vectors by_vectors 5 && in_spans vectors 5 &&
        one counted_pruned by_pruning 3 &&
        one counted_four by_four 3 &&
        one counted_batches by_filter 3 && parts && loops
}
table >"$folder/table" || committed "valgrind does not run here"
cat "$folder/table"
