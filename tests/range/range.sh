#!/bin/sh
# The program range: questions, answers, and a sentence for every
# mistake.
program=range
. "$(dirname "$0")/../near/checks"

# answers NAME EXPECTED ARGUMENTS: on standard output, tabs as spaces.
answers() {
    what=$1 expected=$2
    shift 2
    run "$@" -o -
    says "$what" "$(printf "$expected")" "$(tr '\t' ' ' <"$out")"
}

three >places
printf '0,0,3,4\n0,0.5,1,1\n5,5,4,4\n' >boxes
answers 'points in boxes' \
    'query point\n0 0\n0 1\n0 2\n1 2' --box --queries boxes places
answers 'counts' 'query count\n0 3\n1 1\n2 0' \
    --box --queries boxes --counts places
answers 'the nearest of each point' \
    'query point distance\n0 2 1\n1 2 4.242640687119285\n2 0 1' \
    --nearest 1 places
printf '0 2\n' >one
answers 'the nearest of a place' \
    'query point distance\n0 2 1\n0 0 2' \
    --nearest 2 --queries one places
answers 'all within a distance' \
    'query point distance\n0 2 1\n2 0 1' --within 1 places
answers 'nothing within a distance' 'query point distance' \
    --within 0.5 places
printf 'x;y;z\n1;2;3\n1;2;4\n' >table
answers 'a header, three columns' 'query point distance\n0 1 1\n1 0 1' \
    --nearest 1 table

# Every structure, every question.
for structure in $("$near" --list | sed -n '2,/^$/s/^  \([^ ]*\) .*/\1/p'); do
    for d in 1 2 3 5 8; do
        accepts "boxes, $structure, $d dimensions" --box -n 3000 \
            --dimensions $d --random 200 -a "$structure" --check
    done
    "$near" --list | grep "  $structure .*(box)" >/dev/null && continue
    accepts "nearest, $structure" --nearest 5 -n 2000 -d kuzmin \
        -a "$structure" --check
    accepts "within, $structure" --within 0.1 -n 2000 -d clustered \
        -a "$structure" --check -t 3
done
accepts 'timing' --box -n 100 --timing -r 3
says 'a row a trial' 4 "$(wc -l <"$out" | tr -d ' ')"
accepts 'a file of answers' --box -n 100 -o answers
says 'its head' "$(printf 'query\tpoint')" "$(head -n 1 answers)"
rm answers
accepts 'the manual' --help

refuses 'no points' 'which points?' --box
refuses 'no question' 'what is asked?' -n 5
refuses 'two questions' 'one of --box, --within and --nearest' \
    --box --within 1 -n 5
refuses 'an unknown structure' \
    '-a: there is no structure "heap"' --box -n 5 -a heap
refuses 'a structure without neighbors' 'orthotree finds no neighbors' \
    --nearest 1 -n 5 -a orthotree
refuses 'an unknown option' 'what is --bax?' --bax
refuses 'a negative distance' '--within: expected a distance' \
    --within -1 -n 5
refuses 'nine dimensions' '--dimensions: expected a whole number' \
    --box -n 5 --dimensions 9
refuses 'no file' 'cannot open nowhere' --box nowhere
refuses 'two files' 'one FILE at a time' --box places table
printf '1,2\n3,x\n' >bad
refuses 'a letter' 'bad:2: expected 2 numbers, found "3,x"' --box bad
printf '1,2\n3\n' >bad
refuses 'a missing number' 'bad:2: expected 2 numbers, found "3"' \
    --box bad
printf '1,2\n3,inf\n' >bad
refuses 'an infinite number' 'bad:2: expected finite numbers' --box bad
refuses 'boxes of other points' 'boxes:1: expected 6 numbers' \
    --box --queries boxes table
printf '1 2 3 4 5 6 7 8 9\n' >bad
refuses 'nine columns' 'bad:1: expected 1 to 8 numbers' --box bad
: >bad
refuses 'an empty file' 'bad: expected numbers, found none' --box bad
refuses 'an unwritable file' 'cannot write /nowhere/x' \
    --box -n 5 -o /nowhere/x
