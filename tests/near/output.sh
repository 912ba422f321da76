#!/bin/sh
# The answers are written whole or not at all.
. "$(dirname "$0")/checks"

refuses 'no such folder' 'cannot write nowhere/a.tsv: No such file' \
    -n 10 -o nowhere/a.tsv
mkdir taken
refuses 'a folder of that name' 'cannot write taken: Is a directory' \
    -n 10 -o taken
rmdir taken

if [ -w /dev/full ]; then
    refuses 'a full disk' 'cannot write /dev/full: No space left' \
        -n 10 -o /dev/full
    for arguments in '--list' '--help' '-n 10' '-n 10 --timing' \
        '-n 10 -o -' '-n 5000 -o -'; do
        "$near" $arguments >/dev/full 2>"$err"
        says "near $arguments, full" \
            '2 near: cannot write standard output: No space left on device' \
            "$? $(cat "$err")"
    done
fi
for arguments in '--list' '-n 10' '-n 10 -o -' '-n 10 -o answers.tsv'; do
    "$near" $arguments >&- 2>"$err"
    says "near $arguments, closed" \
        '2 near: cannot write standard output: it is closed' \
        "$? $(cat "$err")"
done
"$near" -n 10 -o answers.tsv 2>&-
says 'standard error closed' '2' "$?"
says 'none of them left a file' '' "$(ls -A)"

ln -s nowhere dangling
refuses 'a link to nowhere' 'cannot write dangling: No such file' \
    -n 10 -o dangling
rm dangling
refuses 'no name' '-o: expected the name of a file' -n 10 -o ''

echo before >private.tsv && chmod 600 private.tsv
"$near" -n 10 -o private.tsv
says 'the rights of a file stay' '-rw-------' \
    "$(ls -l private.tsv | cut -c 1-10)"
rm private.tsv

"$near" -n 4000 -r 1000 --timing -o pipe.tsv | head -n 1 >/dev/null
says 'a broken pipe leaves no file' '' "$(ls -A)"

if [ "$(id -u)" -ne 0 ]; then # root may write anything
    mkdir locked && chmod a-w locked
    refuses 'a locked folder' 'cannot write locked/a.tsv: Permission denied' \
        -n 10 -o locked/a.tsv
    rmdir locked
    echo before >answers.tsv && chmod a-w answers.tsv
    refuses 'a locked file' 'cannot write answers.tsv: Permission denied' \
        -n 10 -o answers.tsv
    rm -f answers.tsv
fi

accepts 'answers' -n 20 -o answers.tsv
says 'are all that is there' answers.tsv "$(ls -A)"
says 'and all that is said' '' "$(cat "$out")"
umask 027
accepts 'the same answers' -n 20 -o again.tsv
cmp -s answers.tsv again.tsv && ok 'two runs, one file' ||
    not_ok 'two runs, one file' 'the files differ'
says 'has the rights of any new file' '-rw-r-----' \
    "$(ls -l again.tsv | cut -c 1-10)"
accepts 'answers on standard output' -n 20 -o -
cmp -s answers.tsv "$out" && ok 'are the same' ||
    not_ok 'are the same' "$(head -n 3 "$out")"

echo before >target && ln -s target link
accepts 'a link' -n 20 -o link
says 'is still one' target "$(readlink link)"
cmp -s answers.tsv target && ok 'and its target has the answers' ||
    not_ok 'and its target has the answers' "$(head -n 3 target)"

# A run that is interrupted, or cannot write all, takes its half-written
# file along, and leaves the old one.
rm -f ./*
echo before >answers.tsv
"$near" -n 4000000 -t 1 -o answers.tsv 2>/dev/null &
process=$!
for moment in $(seq 600); do
    ls -A | grep -q partial && break
    sleep 0.1
done
says 'a long run begins beside its target' 1 "$(ls -A | grep -c partial)"
kill -TERM $process
wait $process 2>/dev/null
says 'ends by the signal' 143 $?
says 'and leaves the old file alone' 'answers.tsv before' \
    "$(ls -A) $(cat answers.tsv)"
(ulimit -f 8 && "$near" -n 5000 -o answers.tsv 2>"$err")
says 'a file too large' \
    '2 near: cannot write answers.tsv: File too large' \
    "$? $(grep -v '^libgcov' "$err")" # whose counts do not fit, either
says 'leaves the old one alone, too' 'answers.tsv before' \
    "$(ls -A) $(cat answers.tsv)"
rm answers.tsv

# Squares that are out of range: an answer all the same, and a warning.
warns() {
    run - -o answers.tsv
    says "$1: status" 0 $status
    says "$1: warning" 1 \
        "$(grep -c "^near: warning: some points are too $2 for" "$err")"
    says "$1: answers" "$3" "$(cut -f 4-7 answers.tsv | tr '\t' ' ' | tail -n +2)"
}
printf '0 0\n1e300 0\n0 1e300\n' | warns 'far apart' 'far apart' '1 inf 1 inf
0 inf 0 inf
0 inf 0 inf'
printf '%s\n' '-1.7e308 0' '0 -1.7e308' '1.7e308 0' | warns 'as far apart as can be' \
    'far apart' '1 inf 1 inf
0 inf 0 inf
0 inf 0 inf'
printf '0 0\n1e-300 0\n0 1e-300\n' | warns 'close' 'close together' '1 0 1 0
0 0 0 0
0 0 0 0'
printf '5 5\n5 5\n5 5\n' >equal.txt
accepts 'the same point three times is no warning' equal.txt
