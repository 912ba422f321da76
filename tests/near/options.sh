#!/bin/sh
# The command line, strictly.
. "$(dirname "$0")/checks"

whole='expected a whole number from'
refuses 'no points at all' 'which points? Name a FILE, or say -n N'
refuses 'only a distribution' 'which points?' -d circle
for n in 0 1 -5 1e12 4294967296 1.5 1e400 nan inf 0x10 10x '' ' 5' +5; do
    refuses "-n '$n'" "-n: $whole 2 to 4294967295, found \"$n\"" -n "$n"
done
for t in 0 -1 1025 two 1.5; do
    refuses "-t '$t'" "-t: $whole 1 to 1024, found \"$t\"" -n 10 -t "$t"
done
# 4294967295 points with one answer are 120 GB.
there=$(awk '/^(MemTotal|SwapTotal):/ { kb += $2 } END { print kb }' /proc/meminfo)
if [ "$there" -lt 117000000 ]; then
    refuses 'more points than memory' '4294967295 points and their answers take 172 GB' -n 4294967295
    refuses 'more points than memory, one answer' '4294967295 points and their answers take 120 GB' -n 4294967295 -a row-spans
fi
refuses '-r 0' "-r: $whole 1 to 1000000" -n 10 -r 0
refuses 'a seed with letters' '-s: expected a whole number' -n 10 -s 12a
refuses 'a seed below zero' '-s: expected a whole number' -n 10 -s -1
refuses 'a seed too large' '-s: expected' -n 10 -s 18446744073709551616
refuses 'an unknown algorithm' \
    '-a: there is no algorithm "oracle"; see near --list' -n 10 -a oracle
refuses 'an unknown distribution' \
    '-d: there is no distribution "gauss"; see near --list' -n 10 -d gauss
refuses 'an unknown geometry' \
    '-g: expected standard or wraparound, found "torus"' -n 10 -g torus
refuses 'an unknown option' 'what is --fast? See near --help' -n 10 --fast
refuses 'an unknown letter' 'what is -q? See near --help' -n 10 -q
refuses 'an unknown letter among others' 'what is -x? See' -n 10 -xyz
refuses 'a value too many' 'what is --check=yes? See' -n 10 --check=yes
refuses 'a value too few' '-n needs a value; see near --help' -n
refuses 'a value too few for a word' '--box needs a value' -n 10 --box
refuses 'two files' 'one FILE at a time, please: "a" and "b" are two' a b
refuses 'a file and a number' 'points come from a file or from -n' a -n 10
refuses 'a file and a seed' 'points come from a file or from -n' a -s 3
refuses 'columns of no file' '--columns is for points from a file' \
    -n 10 --columns 1,2
for columns in 1 0,1 1,2,3 a,b 1.5,2 1, ''; do
    refuses "--columns '$columns'" '--columns: expected two column numbers' \
        a --columns "$columns"
done
for box in 0,0,1 0,0,0,1 1,0,0,1 0,1,1,0 0,0,nan,1 -1e308,0,1e308,1 0,0,1,1,; do
    refuses "--box $box" '--box: expected X0,Y0,X1,Y1' \
        -n 10 -g wraparound --box "$box"
done
refuses 'a box that does not wrap' '--box is for -g wraparound' \
    -n 10 --box 0,0,1,1
refuses 'two tables in one place' '--timing and -o - both want' \
    -n 10 --timing -o -

export NEAR_ISA=mmx
refuses 'an unknown instruction set' \
    'NEAR_ISA: expected portable, avx2 or avx512, found "mmx"' -n 10
NEAR_ISA=portable
accepts 'an instruction set' -n 10
unset NEAR_ISA

accepts 'a number with an exponent' -n 1e2
accepts 'more threads than cores' -n 100 -t 64
accepts 'the largest seed' -n 10 -s 18446744073709551615
accepts '--list' --list
for row in uniform clustered lattice circle kuzmin two-clusters equal collinear; do
    grep -q "^$row  *[a-zA-Z]" "$out" && ok "--list has $row" ||
        not_ok "--list has $row" "it has not"
done

# Threads, if nobody says how many: no more than are worth it.
threads_of() {
    OMP_NUM_THREADS=$1 "$near" -n "$2" | sed -n 's/.*at most \([0-9]*\) .*/\1/p'
}
says 'few points, one thread' 1 "$(threads_of 4 2000)"
says 'some points, some threads' 3 "$(threads_of 4 4001)"
says 'many points, all threads' 4 "$(threads_of 4 8001)"

# Threads that cannot start.
OMP_STACKSIZE=100G
export OMP_STACKSIZE
refuses 'threads whose stacks no memory holds' 'cannot start 4 threads; fewer may do (-t)' -n 100 -t 4
unset OMP_STACKSIZE

# The input by another name.
refuses 'no name of a file' 'expected the name of a file, found ""' ''
printf '1 2\n3 4\n' >in.txt
refuses 'the file at standard input' '-o: in.txt holds the points' - -o in.txt <in.txt
says 'which is as it was' '1 2 3 4' "$(xargs <in.txt)"
rm in.txt

# The corners of a box belong to it.
printf '0 0\n1 1\n0 1\n' >corners.txt
accepts 'points at the corners of the box' corners.txt -g wraparound
rm corners.txt
