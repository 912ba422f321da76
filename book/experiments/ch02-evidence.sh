#!/bin/sh
# Instructions, surprises and cycles, counted: no time is measured
# The steps of the ladder run once under cachegrind, which counts what
# they execute and plays a predictor and caches; llvm-mca works out how
# many cycles short loops take on two processors that it has a model
# of. Where a tool is missing, its rows are those of the book's table.
set -eu
book=book/data/ch02-evidence.tsv
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
has() {
    command -v "$1" >/dev/null 2>&1
}
mca=llvm-mca-14
has "$mca" || mca=llvm-mca
kept() { # the rows of the book's table that begin like this
    [ ! -f "$book" ] || grep "^$1" "$book" || true
}

"$BUILD/ch02/rates" 1 | sed -n '/^#/ {
    s/^# flags:.*/# flags: -std=c17 -O3 -march=x86-64-v3 -ffp-contract=off -fopenmp/
    p
}'
printf 'name\tinstructions\tbranches\twrong\treads\tcycles\n'

# ---- cachegrind: the steps of the ladder, counts for a pair ----------
# cachegrind knows no vectors of eight doubles, hence x86-64-v3.
points=20000
rows=40
count() { # label, geometry, quarter
    valgrind --tool=cachegrind --branch-sim=yes --cache-sim=yes \
        --cachegrind-out-file="$folder/out" "$folder/once" "$2" \
        $points $rows "$3" >"$folder/log" 2>&1 || {
        cat "$folder/log" >&2
        exit 1
    }
    # Exclusive counts of a function, inlined copies included.
    awk -v label="$1" -v pairs=$((rows * (points - 1))) '
        /^events:/ { for (k = 2; k <= NF; k++) at[$k] = k }
        /^fn=/ {
            name = substr($0, 4)
            sub(/\.(constprop|part|isra).*/, "", name)
        }
        /^[0-9]/ {
            instructions[name] += $at["Ir"]
            reads[name] += $at["Dr"]
            branches[name] += $at["Bc"]
            wrong[name] += $at["Bcm"] + $at["Bim"]
        }
        function row(step, a, b) {
            printf "%s_%s\t%.4g\t%.4g\t%.3g\t%.4g\t\n", step, label,
                (instructions[a] + instructions[b]) / pairs,
                (branches[a] + branches[b]) / pairs,
                (wrong[a] + wrong[b]) / pairs,
                (reads[a] + reads[b]) / pairs
        }
        END {
            row("first", "first_search", \
                label == "standard" ? "measure_standard" : "measure_wraparound")
            row("inlined", "inlined_rows"); row("split", "split_rows")
            row("blocks", "blocks_rows"); row("lanes", "lanes_rows")
            row("queries", "queries_rows")
            row("tiles", "tiles_blocked_rows", "tiles_rows")
        }' "$folder/out"
}
if has valgrind && [ "$(uname -m)" = x86_64 ]; then
    ${CC:-cc} -std=c17 -O3 -march=x86-64-v3 -ffp-contract=off \
        -fopenmp -D_GNU_SOURCE -Icode code/ch02-all-pairs/*.c \
        code/ch02-all-pairs/experiments/once.c \
        code/ch02-all-pairs/experiments/rows.c code/common/*.c \
        -lm -o "$folder/once"
    count standard 1 0
    count wraparound 2 0
    count quarter 2 1
else
    kept '[a-z]*_\(standard\|wraparound\|quarter\)'
fi

# ---- llvm-mca: chains ------------------------------------------------
# CHAINS sums side by side: cycles for one addition.
cycles() { # file, processor, iterations
    "$mca" -mcpu="$2" -iterations=1000 "$1" |
        awk '/^Total Cycles:/ { print $3 / 1000 }'
}
sums() { # chains: twelve additions, shared among them
    awk -v chains="$1" 'BEGIN {
        for (k = 0; k < 12; k++)
            printf "vaddpd %%ymm15, %%ymm%d, %%ymm%d\n",
                k % chains, k % chains
    }'
}
if has "$mca"; then
    for chains in 1 2 3 4 6 12; do
        sums $chains >"$folder/sums.s"
        cycles "$folder/sums.s" znver3 | awk -v chains=$chains '{
            printf "chains_%d\t1\t\t\t\t%.3g\n", chains, $1 / 12 }'
    done
else
    kept chains_
fi

# ---- llvm-mca: the innermost loops of two steps ----------------------
# In gcc's assembly, an innermost loop is what stands between a label
# and a jump back to it. The shortest with vectors is the one for the
# standard geometry. Cycles for one pair; a turn is for eight.
innermost() { # function; assembly on standard input
    awk -v function_="$1" '
        /^[a-z_0-9]+:/ { name = $1 }
        /^\.L[0-9]+:/ { label = $1; n = 0; next }
        /^\t\./ { next }
        { line[++n] = $0 }
        $1 ~ /^j/ && $2 ":" == label {
            text = ""; vectors = 0
            for (k = 1; k <= n; k++) {
                text = text line[k] "\n"
                vectors += line[k] ~ /v(min|max)pd/
            }
            if (name == function_ ":" && vectors == 4 &&
                (!best || n < best)) { best = n; found = text }
            n = 0
        }
        END { printf "%s", found }'
}
if has "$mca" && [ "$(uname -m)" = x86_64 ]; then
    ${CC:-cc} -std=c17 -O3 -march=znver3 \
        -ffp-contract=off -fopenmp -D_GNU_SOURCE -Icode -S \
        -o "$folder/tiles.s" code/ch02-all-pairs/tiles.c
    innermost queries_rows <"$folder/tiles.s" >"$folder/loop.s"
    for processor in znver3 icelake-server; do
        cycles "$folder/loop.s" $processor |
            awk -v name="loop_$processor" \
                -v count="$(grep -c . "$folder/loop.s")" '{
                gsub(/-/, "_", name)
                printf "%s\t%.3g\t\t\t\t%.3g\n", name, count / 8, $1 / 8 }'
    done
else
    kept loop_
fi

# ---- the same loops as cachegrind saw them: instructions for a pair --
if [ "$(uname -m)" = x86_64 ]; then
    for step in ladder:lanes tiles:queries; do
        ${CC:-cc} -std=c17 -O3 -march=x86-64-v3 -ffp-contract=off \
            -fopenmp -D_GNU_SOURCE -Icode -S -o "$folder/step.s" \
            "code/ch02-all-pairs/${step%:*}.c"
        innermost "${step#*:}_rows" <"$folder/step.s" |
            awk -v name="inner_${step#*:}" 'END {
                printf "%s\t%.3g\t\t\t\t\n", name, NR / 8 }'
    done
else
    kept inner_
fi
