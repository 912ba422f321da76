#!/bin/sh
# NumPy's arrays, in and out, against NumPy itself where there is one.
. "$(dirname "$0")/checks"

# npy HEAD: an array of version 1 with this head; its numbers follow.
npy() {
    printf '\223NUMPY\001\000'
    printf "\\$(printf %o $((${#1} % 256)))\\$(printf %o $((${#1} / 256)))"
    printf '%s' "$1"
}
head_of() { # SHAPE [TYPE [BY-COLUMNS]]
    echo "{'descr': '${2:-<f8}', 'fortran_order': ${3:-False}, 'shape': ($1), }      "
}
zeros() { head -c "$1" /dev/zero; }
# The doubles 1, 2, 0.5, -1, 3, 3 as they lie in memory.
six() {
    for high in '\360\077' '\000\100' '\340\077' '\360\277' '\010\100' '\010\100'; do
        printf "\\000\\000\\000\\000\\000\\000$high"
    done
}

# reads NAME "X Y X Y ...": an array on standard input
reads() {
    cat >points.npy
    accepts "$1" points.npy -o answers.tsv
    says "$1: its points" "$2" \
        "$(tail -n +2 answers.tsv | cut -f 2,3 | tr '\t\n' '  ' | sed 's/ $//')"
}
{ npy "$(head_of '3, 2')"; six; } | reads 'rows' '1 2 0.5 -1 3 3'
{ npy "$(head_of '3, 2' '<f8' True)"; six; } | reads 'columns' '1 -1 2 3 0.5 3'
{ npy "{'descr':'<f8','fortran_order':False,'shape':(3,2)}"; six; } |
    reads 'no more spaces than needed' '1 2 0.5 -1 3 3'
{ npy "$(head_of '2, 3')"; six; } >points.npy
accepts 'two columns of three' points.npy --columns 3,2 -o answers.tsv
says 'two columns of three: its points' '0.5 2 3 3' \
    "$(tail -n +2 answers.tsv | cut -f 2,3 | xargs)"
accepts 'an array from a pipe' - --columns 3,2 -o again.tsv <points.npy
cat points.npy | accepts 'an array from a slow pipe' - --columns 3,2 -o again.tsv
cmp -s answers.tsv again.tsv && ok 'the same' || not_ok 'the same' 'the files differ'

# refuses_array NAME SENTENCE ARGUMENTS: an array on standard input, read
# as a file and from a pipe
refuses_array() {
    name=$1 expected=$2
    shift 2
    cat >points.npy
    refuses "$name" "points.npy: expected $expected" points.npy "$@"
    cat points.npy | refuses "$name, from a pipe" "standard input: expected $expected" - "$@"
}
{ npy "$(head_of '3, 2' '<f4')"; six; } |
    refuses_array 'floats' "an array of doubles, '<f8', found '<f4'"
{ npy "$(head_of '3, 2' '>f8')"; six; } |
    refuses_array 'the other byte order' "an array of doubles, '<f8', found '>f8'"
{ npy "$(head_of '3, 2' '<i8')"; six; } |
    refuses_array 'integers' "an array of doubles, '<f8', found '<i8'"
{ npy "{'descr': [('x', '<f8'), ('y', '<f8')], 'fortran_order': False, 'shape': (3,), }"; six; } |
    refuses_array 'records' "an array of doubles, '<f8', found [('x'"
{ npy "$(head_of '6,')"; six; } |
    refuses_array 'one axis' 'an array of shape (n, 2), found 6,'
{ npy "$(head_of '3, 2, 1')"; six; } |
    refuses_array 'three axes' 'an array of shape (n, 2), found 3, 2, 1'
{ npy "$(head_of '')"; six; } |
    refuses_array 'no axis' 'the head of an array of shape (n, 2), found {'
{ npy "$(head_of '6, 1')"; six; } | refuses_array 'one column' '2 columns, found 1'
{ npy "$(head_of '2, 3')"; six; } |
    refuses_array 'three columns' '2 columns (or --columns I,J), found 3'
{ npy "$(head_of '2, 3')"; six; } |
    refuses_array 'a fourth column' '4 columns, found 3' --columns 4,1
{ npy "$(head_of '4294967296, 2')"; six; } |
    refuses_array 'too many points' 'at most 4294967295 points, found 4294967296'
{ npy "$(head_of '0, 2')"; } | refuses_array 'no point' 'points, found none'
{ npy "$(head_of '1, 2')"; zeros 16; } >points.npy
refuses 'one point' 'points.npy: expected at least two points, found one' points.npy
{ npy "$(head_of '4, 2')"; six; } |
    refuses_array 'a file cut short' '8 numbers, as its head says, found 6'
{ npy "$(head_of '3, 2')"; six; printf x; } |
    refuses_array 'a file too long' '6 numbers, as its head says, found more'
{ npy "$(head_of '2, 2')"; zeros 30; printf '\370\377'; } |
    refuses_array 'NaN' 'finite numbers, found 0 and '
{ npy "$(head_of '2, 2' '<f8' Perhaps)"; zeros 32; } |
    refuses_array 'an order of another kind' 'the head of an array of shape (n, 2), found {'
{ npy "$(head_of '2, 2')x"; zeros 32; } |
    refuses_array 'something behind the head' 'the head of an array'
npy "$(head_of '2, 2')" | head -c 40 |
    refuses_array 'a head cut short' 'the head of an array, found its first 40 bytes'
printf '\223NUMPY\004\000\002\000{}  ' |
    refuses_array 'another version' 'version 1.0, 2.0 or 3.0 of the format, found 4.0'
printf '\223NUMPY\003\000\377\377\377\377{}  ' |
    refuses_array 'a head without end' 'an array, found a head of 4294967295 bytes'
printf '\223NUM 1\n' >points.npy
refuses 'only half of the magic' 'points.npy:1: expected two numbers' points.npy
rm -f points.npy again.tsv

# The table of answers, by any number of threads.
accepts 'an array of answers' -n 30000 -t 1 -o answers.npy
for threads in 2 5; do
    accepts "an array of answers, $threads threads" -n 30000 -t $threads -o again.npy
    cmp -s answers.npy again.npy && ok "the same from $threads threads" ||
        not_ok "the same from $threads threads" 'the files differ'
done
says 'its bytes, 44 for a point behind a head' 0 \
    $((($(wc -c <answers.npy) - 30000 * 44) % 64))
refuses 'an array of answers is none of points' \
    "answers.npy: expected an array of doubles, '<f8', found [('i'" answers.npy
accepts 'only the nearest' -n 100 -a row-spans -o nearest.npy

for python in python3 /usr/bin/python3 ''; do
    [ -n "$python" ] && "$python" -c 'import numpy' 2>/dev/null && break
done
if [ -z "$python" ]; then
    ok 'no NumPy here: ./setup test installs it; its half of the test is left out'
    exit
fi

cat >make.py <<'END'
import numpy
bits = numpy.random.default_rng(1).integers(0, 2**64, (20001, 2), dtype="u8")
points = bits.view("<f8")
points = numpy.where(numpy.isfinite(points), points, 5e-324) * 1e-155
numpy.save("rows.npy", points)
numpy.save("columns.npy", numpy.asfortranarray(points))
numpy.save("transposed.npy", points.T.copy().T)
numpy.savetxt("points.txt", points, fmt="%.17g")
for version in (1, 0), (2, 0), (3, 0):
    with open("version%d.npy" % version[0], "wb") as file:
        numpy.lib.format.write_array(file, points, version=version)
END
"$python" make.py
run points.txt -o text.npy
says 'a text by NumPy: status' 0 $status
for name in rows columns transposed version1 version2 version3; do
    run $name.npy -o array.npy
    says "an array by NumPy, $name: status" 0 $status
    cmp -s text.npy array.npy && ok 'the answers of the text' ||
        not_ok 'the answers of the text' 'the files differ'
done
"$near" rows.npy -o text.tsv 2>/dev/null
cat >check.py <<'END'
import numpy
answers = numpy.load("text.npy")
points = numpy.load("rows.npy")
nearest = numpy.load("nearest.npy")
print(answers.dtype.names, answers.shape, nearest.dtype.names)
assert (answers["x"] == points[:, 0]).all() and (answers["y"] == points[:, 1]).all()
table = numpy.loadtxt("text.tsv", skiprows=1)
for column, name in enumerate(answers.dtype.names):
    assert (table[:, column] == answers[name]).all(), name
END
says 'what NumPy reads' "('i', 'x', 'y', 'nearest', 'nearest_distance', 'furthest', 'furthest_distance') (20001,) ('i', 'x', 'y', 'nearest', 'nearest_distance')" \
    "$("$python" check.py 2>&1 | tail -n 1)"
