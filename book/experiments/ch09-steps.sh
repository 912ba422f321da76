#!/bin/sh
# The search of chapter 9, step by step, with the widest vectors and with AVX2's
# demo: table
set -eu
steps() {
    "$BUILD/ch09/steps" ${FULL:+1000000 5}
}
steps
# Once more as a processor without AVX-512 does it; one that has no AVX2
# either repeats what it can.
rows=$(NEAR_ISA=avx2 steps 2>/dev/null) || rows=$(steps)
printf '%s\n' "$rows" | sed -e '/^#/d' -e '/^name/d' -e 's/^/avx2_/'
