#!/bin/sh
# What the compiler made of the loops: arithmetic on doubles, in vectors and one by one
# Counted in the disassembly (x86): packed and scalar additions,
# subtractions, multiplications, minima, maxima, and calls through a
# pointer.
set -eu
"$BUILD/ch02/rates" 1 | grep "^#"
objdump -d --no-show-raw-insn "$BUILD"/plain/ch02-all-pairs/*.o \
    "$BUILD"/plain/ch02-all-pairs/experiments/choices.o | awk -F '\t' '
    BEGIN {
        print "name\tvector\tscalar\tcalls"
        split("pointer_rows flag_rows copies_rows pointer_lanes_rows " \
            "flag_lanes_rows copies_lanes_rows first_search inlined_rows " \
            "split_rows blocks_rows lanes_rows queries_rows " \
            "tiles_blocked_rows", order, " ")
    }
    /^[0-9a-f]+ <.*>:$/ { name = $0; gsub(/.*<|>:/, "", name) }
    $2 ~ /^v?(add|sub|mul|min|max|fn?m(add|sub)[0-9]*)pd / { vector[name]++ }
    $2 ~ /^v?(add|sub|mul|min|max|fn?m(add|sub)[0-9]*)sd / { scalar[name]++ }
    $2 ~ /^call +\*/ { calls[name]++ }
    END {
        for (k = 1; k in order; k++)
            print order[k] "\t" vector[order[k]] + 0 "\t" \
                scalar[order[k]] + 0 "\t" calls[order[k]] + 0
    }'
