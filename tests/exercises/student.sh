#!/bin/sh
# What a student meets: every broken attempt is told as what it is, and
# none ends the grader or touches the scores.

: "${BUILD:=build}"
export BUILD
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder" "$BUILD/$folder"' EXIT
WORK=$folder/work LIMIT=2 TEST="two-points ties" SEED=1
export WORK LIMIT TEST SEED
file=$WORK/2.1/nearest-pair.c
scores=$BUILD/$WORK/2.1/scores.tsv
said=$folder/said
. tests/checks

# attempt NAME WORDS BODY: the function with this body loses all points,
# and the report says the words.
attempt() {
    {
        echo '#include "common/geometry.h"'
        echo '#include "exercise.h"'
        echo '#include <assert.h>'
        echo '#include <stdio.h>'
        echo '#include <stdlib.h>'
        echo 'double helper(void);'
        printf '%s\n' "struct pair nearest_pair(struct points points) { $3 }"
    } >"$file"
    exercises/kit/exercise 2.1 >"$said" 2>&1
    status=$?
    check "$1" all_lost "$2"
}

all_lost() {
    tr -s ' \n' ' ' <"$said" | grep -q -F -e "$1" && [ $status -eq 1 ] &&
        awk -F '\t' 'NR > 1 { n++; p += $2 } END { exit !(n == 2 && p == 0) }' \
            "$scores"
}

lacks_in() {
    ! grep -q -e "$2" "$1"
}

# Nothing of a fence, and no first line of what stands in one.
lacks_answer() {
    lacks ':::' &&
        awk '/^:::+ *[a-z]/{ getline; print substr($0, 1, 40) }' "$text" \
            >"$folder/hidden" &&
        ! grep -q -F -f "$folder/hidden" "$said"
}

# The first call makes the starter, which fails; the next keeps it.
TEST=many exercises/kit/exercise 2.1 >"$said" 2>&1
check "the starter is made" grep -q '^Made ' "$said"
check "its failures are told" grep -q 'expected .*point' "$said"
check "and not what to do" lacks '^    why'
check "nothing else lies beside it" [ "$(ls "$WORK/2.1" | tr '\n' ' ')" = \
    "exercise.h nearest-pair.c task.md " ]
check "not the hints" lacks_in "$WORK/2.1/task.md" 'large number may not'
check "not the answer" lacks_in "$WORK/2.1/task.md" ':::\|Two loops'
check "but the task" grep -q 'Look at every pair once' "$WORK/2.1/task.md"
echo '// mine' >>"$file"
echo '// too' >"$WORK/2.1/mine.c"
TEST=many exercises/kit/exercise 2.1 >"$said" 2>&1
rm "$WORK/2.1/mine.c"
check "another file is told to be none" says 'mine.c is not tested'
check "work is kept" grep -q '^// mine' "$file"
check "and its failures have causes" grep -q '^    why  ' "$said"
WHY=no TEST=many exercises/kit/exercise 2.1 >"$said" 2>&1
check "which can be hidden" lacks '^    why'
check "in the scores as well" \
    awk -F '\t' 'NR > 1 && $4 == "wrong" && $11 == "" { n++ } END { exit !n }' "$scores"

cp exercises/ch02/1-nearest-pair/solution.c "$file"
TEST='' exercises/kit/exercise 2.1 >"$said" 2>&1
check "the solution ends with status 0" [ $? -eq 0 ]
check "the next exercise is named" says 'Next: make exercise2.2'
check "its points are shown" grep -q '10 / 10' "$said"
check "its points are written" \
    awk -F '\t' 'NR > 1 { p += $2 } END { exit p != 10 }' "$scores"

# A part of the points, told once, though in both runs.
part=$WORK/12.5/a-median-for-little.c
mkdir -p "$WORK/12.5"
sed 's/if (n > 600 &&/if (n > 4000000000u \&\&/' \
    exercises/ch12/5-a-median-for-little/solution.c >"$part"
LIMIT=20 TEST=count exercises/kit/exercise 12.5 >"$said" 2>&1
check "a part of the points is told once" [ "$(grep -c '^PARTLY' "$said")" -eq 1 ]
check "as a part in the table, too" grep -q 'partly  *partly  *3 / 6' "$said"

: >"$file"
exercises/kit/exercise 2.1 >"$said" 2>&1
check "an empty file" grep -q 'The file is empty' "$said"
check "a missing function" grep -q 'not define the function' "$said"

echo 'struct pair x(void) { return 0 }' >"$file"
exercises/kit/exercise 2.1 >"$said" 2>&1
check "what does not compile" grep -q 'does not compile' "$said"
check "is told once" [ "$(grep -c 'why .*does not compile' "$said")" -eq 1 ]
check "and so in the table" grep -q 'does not   compile  *0 / ' "$said"
check "and without a seed" lacks 'seed\|again'
check "and loses all" \
    awk -F '\t' 'NR > 1 { n++; p += $2 } END { exit !(n == 2 && p == 0) }' "$scores"

attempt "an endless loop" "A loop that never ends" \
    'for (;;) if (points.n == 7) continue;'
check "after how long, and where" grep -q "no answer after 2 seconds, in line 7" "$said"
check "and the next test has less" grep -q 'The time for this exercise is used' "$said"
TEST="two-points ties same-place many" exercises/kit/exercise 2.1 >"$said" 2>&1
check "and the rest is not tried" grep -q 'not tried, because two tests' "$said"
check "which is told once" [ "$(grep -c 'not tried, because' "$said")" -eq 1 ]
attempt "an endless recursion" "A recursion without end" \
    'struct pair p = nearest_pair(points); p.i++; return p;'
attempt "an exit in the middle" "exit() ends everything" \
    'printf("{\"score\": 10}\n"); exit(0);'
check "what it printed is shown" grep -q '    | {"score": 10}' "$said"
attempt "an assertion" "ended itself with abort" \
    'assert(points.n == 0); abort();'
attempt "a write to the points" "it writes to points.x, in line 7" \
    'points.x[0] = 3; return (struct pair){0, 1, 0};'
attempt "an index too large" "element 2 of points.y, which has 2, in line 7" \
    'return (struct pair){0, 1, points.y[points.n]};'
check "is told once" grep -q 'The same as in two-points happens in: ties' "$said"
attempt "a negative index" "An index became negative" \
    'volatile int k = -1; return (struct pair){0, 1, points.x[k]};'
attempt "a null pointer" "pointer that was never set" \
    'points.x = NULL; return (struct pair){0, 1, points.x[0]};'
attempt "a heap overflow" "memory that you allocated" \
    'char *c = malloc(points.n); c[points.n] = 1; return (struct pair){c[0], 1, 0};'
attempt "an integer division by zero" "nothing to divide by" \
    'unsigned z = points.n - points.n; return (struct pair){1 / z, 1, 0};'
LIMIT=60 # the memory that it may have takes a while to fill
attempt "memory without end" "memory allocated in a loop without end" \
    'for (;;) *(char *)malloc(100000000) = 3;'
LIMIT=2
attempt "output without end" "prints more than a megabyte" \
    'for (;;) puts("hello");'
attempt "a made-up report" "found xxxxxxxxxx" \
    'fputs("x: runtime error: ", stderr); for (int i = 0; i < 5000; i++) putc(120, stderr); exit(99);'
attempt "an undefined function" "does not define helper" \
    'return (struct pair){0, 1, helper()};'
attempt "a point that is its own neighbor" "not its own neighbor" \
    'return (struct pair){1, 1, 0};'

exercises/kit/exercise 2.77 >"$said" 2>&1
check "an unknown exercise" grep -q 'there is no exercise 2.77' "$said"
exercises/kit/exercise 2 >"$said" 2>&1
check "a number that is none" grep -q 'say make exercise2.1' "$said"
for text in exercises/ch*/*/exercise.md; do
    [ -e "${text%exercise.md}tests.c" ] && continue
    key=$(echo "$text" | sed 's,[^/]*/ch0*\([0-9]*\)/\([0-9]*\).*,\1.\2,')
    exercises/kit/exercise "$key" >"$said" 2>&1
    check "$key is shown, on paper" grep -q "^Exercise $key: .*on paper" "$said"
    check "$key without hint and answer" lacks_answer
    check "$key without the press's markup" lacks '{[.#]\|]{\|@[a-z]*:\| $'
    check "$key without TeX" lacks '\$\|\\[a-z]'
done
