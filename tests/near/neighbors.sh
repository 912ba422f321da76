#!/bin/sh
# The k nearest, and all within a distance: tables, and refusals.
. "$(dirname "$0")/checks"

table() { tr '\t\n' ' ;' <"${1:-$out}"; }

three | accepts 'two nearest of three' -k 2 - -o -
three | run -k 2 - -o -
nearest='i neighbor distance;0 2 1;0 1 5;1 2 4.242640687119285;1 0 5;2 0 1;2 1 4.242640687119285;'
says 'the nearest first' "$nearest" "$(table)"
three | run -k 1000 - -o -
says 'as many as there are' "$nearest" "$(table)"
three | run --within 5 - -o -
says 'what is just as far is in' "$nearest" "$(table)"
three | run --within 4.5 - -o -
says 'what is further is not' 'i neighbor distance;0 2 1;1 2 4.242640687119285;2 0 1;2 1 4.242640687119285;' "$(table)"
three | run --within 1 --counts - -o -
says 'counts' 'i count;0 1;1 0;2 1;' "$(table)"
three | run --within 0.5 - -o -
says 'none within the distance' 'i neighbor distance;' "$(table)"
printf '0 0\n1 0\n0 1\n-1 0\n0 0\n' | run -k 3 - -o -
says 'the lowest of equal ones, and duplicates' '0 4 0;0 1 1;0 2 1;' \
    "$(grep '^0' "$out" | table /dev/stdin)"
printf '0.1 0.5\n0.9 0.5\n0.5 0.5\n' | run -k 1 -g wraparound - -o -
says 'over the border' '0 1' "$(sed -n 2p "$out" | cut -f 1-2 | tr '\t' ' ')"

for kind in uniform kuzmin lattice half-equal equal geometric; do
    for question in '-k 1' '-k 8' '-k 70' '--within 0.03' '--within 0.03 --counts' '--within 0'; do
        run -n 700 -d $kind $question --check
        says "$kind $question" 'check: all 700 right' \
            "$(sed -n 's/ 700 .* are/ 700/p' "$out")"
    done
done
for t in 1 2 4; do
    run -n 20000 -d clustered -k 8 -t $t -o $t.tsv
    says "$t threads" '' "$(cmp 1.tsv $t.tsv 2>&1)"
done
accepts 'an array' -n 100 -k 3 -o array.npy
says 'the records of an array' $((128 + 300 * 16)) "$(wc -c <array.npy | tr -d ' ')"
accepts 'times' -n 100 -k 3 -r 3 --timing
says 'a line a trial' 4 "$(wc -l <"$out" | tr -d ' ')"

whole='expected a whole number from 1 to 4294967295'
for k in 0 -1 1.5 x nan ''; do
    refuses "-k '$k'" "-k: $whole, found \"$k\"" -n 10 -k "$k"
done
for r in -1 -0 x nan inf '' 0x1 1,2; do
    refuses "--within '$r'" "--within: expected a distance, 0 or more, found \"$r\"" \
        -n 10 --within "$r"
done
refuses 'two questions' 'one of -k and --within at a time' -n 10 -k 3 --within 1
refuses 'an algorithm that answers something else' '-a is for one nearest and one furthest' \
    -n 10 -k 3 -a row-spans
refuses 'counts of nothing' '--counts is for --within' -n 10 -k 3 --counts
refuses 'one point' 'standard input: expected at least two points' - -k 3 <<EOF
1 1
EOF
