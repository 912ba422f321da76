#!/bin/sh
# What near answers, against awk, which has never heard of it.
. "$(dirname "$0")/checks"

# awk computes in doubles too, and must find the same to the last digit.
# With width 0 the space does not wrap around.
check_by_awk() { # NAME WIDTH HEIGHT, answers.tsv
    wrong=$(awk -F '\t' -v w="$2" -v h="$3" '
        function wrap(d, side, far) {
            if (d < 0) d = -d
            if (side && (far ? side - d > d : side - d < d)) d = side - d
            return d
        }
        function apart(i, j, far) {
            dx = wrap(x[i] - x[j], w, far)
            dy = wrap(y[i] - y[j], h, far)
            return dx * dx + dy * dy
        }
        NR > 1 { x[$1] = $2; y[$1] = $3; line[$1] = $0; n++ }
        END {
            for (i = 0; i < n; i++) {
                near = far = -1
                for (j = 0; j < n; j++)
                    if (j != i) {
                        d = apart(i, j, 0); e = apart(i, j, 1)
                        if (near < 0 || d < near2) { near = j; near2 = d }
                        if (far < 0 || e > far2) { far = j; far2 = e }
                    }
                split(line[i], f, "\t")
                if (f[4] != near || f[5] + 0 != sqrt(near2) ||
                    f[6] != far || f[7] + 0 != sqrt(far2))
                    print "point " i ": " near, sqrt(near2), far, sqrt(far2)
            }
            if (n == 0) print "no points"
        }' answers.tsv | head -n 1)
    says "$1" '' "$wrong"
}

accepts 'random points' -n 300 -s 5 -o answers.tsv
says 'the header' "$(printf 'i\tx\ty\tnearest\tnearest_distance\tfurthest\tfurthest_distance')" \
    "$(head -n 1 answers.tsv)"
check_by_awk 'random points as awk finds them' 0 0
accepts 'random points, wraparound' -n 300 -s 6 -g wraparound -o answers.tsv
check_by_awk 'random points, wraparound, as awk finds them' 1 1
accepts 'ties' -n 100 -d lattice -o answers.tsv
check_by_awk 'ties as awk finds them' 0 0
accepts 'a box' -n 200 -d clustered -g wraparound --box -2,-3,3,5 -o answers.tsv
check_by_awk 'a box as awk finds it' 5 8

# Each algorithm, by name, with one thread and with two. Columns that it
# does not answer are left out, here and in what we compare with.
columns_of() {
    case $(head -n 1 "$1") in
    *nearest*furthest*) echo 1-7 ;;
    *nearest*) echo 1-5 ;;
    *) echo 1-3,6-7 ;;
    esac
}
accepts 'the first answers' -n 500 -d clustered -o first.tsv
for name in $("$near" --list | awk 'NR > 1 && $2 ~ /^[0-9]+$/ { print $1 }'); do
    for threads in 1 2; do
        accepts "$name, $threads threads" -n 500 -d clustered -a "$name" \
            -t $threads --check -o again.tsv
        cut -f "$(columns_of again.tsv)" first.tsv | cmp -s - again.tsv &&
            ok "$name, the same file" ||
            not_ok "$name, the same file" "$(diff first.tsv again.tsv)"
    done
done

# And with each set of instructions that the machine has, those that use
# them; larger, so that strips and tiles are full.
for row in 'vector-spiral -d clustered' 'row-spans -d clustered' \
    'near-and-far -d clustered' 'vector-spiral -d lattice -g wraparound' \
    'row-spans -d lattice -g wraparound' 'near-and-far -g wraparound'; do
    accepts "$row, the best instructions" -n 3000 -a $row -o first.tsv
    for isa in portable avx2 avx512; do
        NEAR_ISA=$isa "$near" -n 2 >/dev/null 2>&1 || continue
        export NEAR_ISA=$isa
        run -n 3000 -a $row --check -o again.tsv
        unset NEAR_ISA
        says "$row, $isa: status" 0 $status
        cmp -s first.tsv again.tsv && ok "$row, $isa, the same file" ||
            not_ok "$row, $isa, the same file" 'the files differ'
    done
done

three | accepts 'a file from standard input' - -o answers.tsv
says 'its answers' "0	0	0	2	1	1	5
1	3	4	2	4.242640687119285	0	5
2	0	1	0	1	1	4.242640687119285" "$(tail -n +2 answers.tsv)"
printf 'name;y;x\nUlm;4;3\nRom;0;0\nBonn;1;0\n' |
    accepts 'columns' - --columns 3,2 -o answers.tsv
says 'in their order' '3 4
0 0
0 1' "$(tail -n +2 answers.tsv | cut -f 2,3 | tr '\t' ' ')"
printf 'NAME: c\nDIMENSION: 2\nNODE_COORD_SECTION\n1 245552.778 0.1\n2 0 0\nEOF\n' |
    accepts 'a TSPLIB file' - -o answers.tsv
says 'coordinates are as short as in the file' '245552.778	0.1' \
    "$(sed -n 2p answers.tsv | cut -f 2,3)"

accepts 'a generated file' -n 50 -d kuzmin -o points.tsv
cut -f 2,3 points.tsv >coordinates.tsv
accepts 'is read back' coordinates.tsv -o again.tsv
cmp -s points.tsv again.tsv && ok 'to the last bit' ||
    not_ok 'to the last bit' 'the files differ'

# Any number of threads reads and writes the same: a file long enough
# for each to have its part, with lines of every kind.
awk -v OFS=', ' 'BEGIN {
    print "\357\273\277name,x,y # a header"
    for (i = 0; i < 60000; i++)
        print (i % 7 ? "point" : "\"a, b #" i "\""), (i * 7919 % 60013) / 64,
            i / 3 (i % 5 ? "" : " # a note, too") (i % 11 ? "" : "\r") (i % 13 ? "" : "\n\n#")
}' >mixed.csv
accepts 'a long file, one thread' mixed.csv --columns 2,3 -t 1 -o first.tsv
says 'all its points' 60001 "$(wc -l <first.tsv | tr -d ' ')"
for threads in 2 3 8; do
    accepts "a long file, $threads threads" mixed.csv --columns 2,3 -t $threads -o again.tsv
    cmp -s first.tsv again.tsv && ok "the same from $threads threads" ||
        not_ok "the same from $threads threads" 'the files differ'
done
cat mixed.csv | accepts 'a pipe' - --columns 2,3 -o again.tsv
cmp -s first.tsv again.tsv && ok 'the same from a pipe' ||
    not_ok 'the same from a pipe' 'the files differ'
accepts 'standard input' - --columns 2,3 -o again.tsv <mixed.csv
cmp -s first.tsv again.tsv && ok 'the same from standard input' ||
    not_ok 'the same from standard input' 'the files differ'
tail -n +2 first.tsv | cut -f 2,3 >coordinates.tsv
accepts 'the answers to themselves' coordinates.tsv -o again.tsv
cmp -s first.tsv again.tsv && ok 'are the same' ||
    not_ok 'are the same' 'the files differ'

accepts 'a summary' -n 100 -d lattice -t 2
says 'has its points' 'points    100 lattice' "$(sed -n 1p "$out")"
says 'has its geometry' 'geometry  standard' "$(sed -n 2p "$out")"
says 'has its nearest distance' 'nearest   0.1 on average' \
    "$(sed -n 3p "$out")"
grep -q '^furthest  [0-9.]* on average' "$out" && ok 'has the furthest' ||
    not_ok 'has the furthest' "$(cat "$out")"
grep -q '^time  .* s, .* at most 2 threads' "$out" && ok 'has a time' ||
    not_ok 'has a time' "$(cat "$out")"

accepts 'a check' -n 100 --check
says 'says that all is right' "check: all 100 nearest neighbors are right
check: all 100 furthest neighbors are right" "$(head -n 2 "$out")"

first=$("$near" --list | awk '$2 ~ /^[0-9]+$/ { print $1; exit }')
accepts 'timing' -n 100 -r 3 -t 2 -a "$first" --timing
says 'has its columns' \
    'algorithm	n	threads	build_ns	query_ns	total_ns	distances' \
    "$(head -n 1 "$out")"
says 'has a row for each trial' "$first 100 2
$first 100 2
$first 100 2" "$(tail -n +2 "$out" | cut -f 1-3 | tr '\t' ' ')"
says 'its times add up' '' \
    "$(awk 'NR > 1 && ($4 + $5 != $6 || $5 <= 0)' "$out")"
says 'the counts are the same' 1 "$(tail -n +2 "$out" | cut -f 7 | uniq | wc -l)"
