#!/bin/sh
# What the loops of the primitives ask of a processor: instructions, cycles by llvm-mca, wrong guesses by cachegrind
# The loops are taken from the disassembly of this machine's build and
# given to llvm-mca's model of an Ice Lake, the oldest that it has with
# all of these instructions: cycles and uses of port 5, where lanes
# change places, for an element. Cachegrind runs the packs of `branches`
# on its own model of a branch predictor: wrong guesses for an element.
# Where one of the tools is missing, the committed table stays.
set -eu
mca=$(command -v llvm-mca-14 || command -v llvm-mca || :)
object_dir=$BUILD/plain/ch06-pack-scan
if [ ! "$mca" ] || [ ! -e "$object_dir/avx2.o" ] || [ "$(uname -m)" != x86_64 ] ||
    ! command -v valgrind >/dev/null || ! command -v objdump >/dev/null
then
    echo "llvm-mca, valgrind or objdump is missing" >&2
    cat book/data/ch06-evidence.tsv
    exit
fi
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
trap 'exit 1' HUP INT TERM
"$BUILD/ch06/predictors" | grep "^#"
printf 'name\telements\tinstructions\tcycles\tshuffles\twrong\n'

# The innermost loop of a function: from the last address that a later
# jump goes back to, up to that jump. Of unrolled loops, the largest.
loop() { # object function
    objdump -d --no-show-raw-insn "$object_dir/$1.o" |
        awk -F '\t' -v name="<$2>:" '
        /^[0-9a-f]+ <.*>:$/ { inside = index($0, name) > 0; n = 0 }
        inside && NF > 1 {
            address = $1; gsub(/[ :]/, "", address)
            text = $2; sub(/ *#.*/, "", text); sub(/ *<.*>$/, "", text)
            at[address] = ++n; line[n] = text
            if (text ~ /^j/) {
                split(text, part, / +/)
                if (part[2] in at) {
                    size = n - at[part[2]]
                    if (size > most) {
                        most = size; found = ""
                        for (k = at[part[2]]; k < n; k++)
                            found = found line[k] "\n"
                        found = found part[1] " 0\n"
                    }
                }
            }
        }
        END { printf "%s", found }'
}

# A row: name, elements for a turn of the loop, the loop itself.
row() { # name object function elements
    loop "$2" "$3" >"$dir/loop.s"
    "$mca" -mtriple=x86_64 -mcpu=icelake-server -iterations=200 \
        "$dir/loop.s" >"$dir/report"
    awk -v name="$1" -v elements="$4" -v turns=200 '
        /^Instructions:/ { instructions = $2 / turns / elements }
        /^Total Cycles:/ { cycles = $3 / turns / elements }
        # Two columns for the dividers, then ports 0 to 9.
        /^Resource pressure per iteration:/ { getline; getline
            split($0, busy, " ") }
        END {
            shuffles = busy[8] == "-" ? 0 : busy[8] / elements
            printf "%s\t%d\t%.3f\t%.3f\t%.3f\tnan\n", name, elements,
                instructions, cycles, shuffles
        }' "$dir/report"
}
row portable_gather primitives portable_gather 4
row portable_scan primitives portable_scan 4
row portable_pack primitives portable_pack 4
row avx2_scan avx2 scan 8
row avx2_pack avx2 pack 8
row avx512_scan avx512 scan 16
row avx512_pack avx512 pack 16

# valgrind does not know all the instructions of this machine: a build
# for any processor, one pack at every share from 0 to 100 percent.
${CC:-cc} -std=c17 -O3 -ffp-contract=off -fopenmp -g -D_GNU_SOURCE \
    -Icode -o "$dir/branches" \
    code/ch06-pack-scan/experiments/branches.c \
    code/ch06-pack-scan/primitives.c \
    code/ch06-pack-scan/avx2.c code/ch06-pack-scan/avx512.c \
    code/common/*.c -lm
NEAR_ISA=portable valgrind --tool=cachegrind --branch-sim=yes \
    --cache-sim=no --cachegrind-out-file="$dir/out" \
    "$dir/branches" 131072 1 >/dev/null 2>"$dir/log" ||
    { cat "$dir/log" >&2; exit 1; }
awk '/^events:/ { for (k = 2; k <= NF; k++) if ($k == "Bcm") bcm = k
                  events = NF - 1 }
     /^fn=/ { name = substr($0, 4) }
     /^[0-9]/ { if (NF > events) wrong[name] += $bcm }
     END {
         runs = 2 * 21; n = 131072 # each share once to warm up
         printf "branch\t1\tnan\tnan\tnan\t%.4f\n",
             wrong["pack_branching"] / runs / n
         printf "no_branch\t1\tnan\tnan\tnan\t%.4f\n",
             wrong["portable_pack"] / runs / n
     }' "$dir/out"
