#!/bin/sh
# pow against a multiplication, with and without optimization
# The program is compiled a second time, without -O3.
set -eu
${CC:-cc} -std=c17 -O0 -ffp-contract=off -fopenmp -D_GNU_SOURCE -Icode \
    code/ch02-all-pairs/experiments/pow.c \
    code/ch02-all-pairs/experiments/rows.c code/ch02-all-pairs/first.c \
    code/common/*.c -lm \
    -o "$BUILD/ch02/pow-plain"
"$BUILD/ch02/pow" ${FULL:+2000 15}
"$BUILD/ch02/pow-plain" ${FULL:+2000 15} | grep -v "^#" | tail -n +2
