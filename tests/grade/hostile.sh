#!/bin/sh
# Submissions that want to harm, to earn what they have not earned, or
# to see what is not theirs: every file of hostile/, and files that are
# none. Each gets the score that its second line says, the report says
# its third line's words, the results are complete and valid, and
# nothing is left behind. Further lines may name words that must not be
# said, and another exercise than 2.1, its file and its test.
#
#   tests/grade/hostile.sh NAME...    only these

: "${BUILD:=build}"
export BUILD
here=tests/grade
LIMIT=1 SEED=1 TEST=ties EXERCISES=2.1 COMPILE_LIMIT=10
export LIMIT SEED TEST EXERCISES COMPILE_LIMIT
solution=exercises/ch02/1-nearest-pair/solution.c

# expect SCORE WORDS: what the submission in $case must get
expect() {
    printf '%s\n%s\n' "$1" "$2" >"$case/expected"
}

# Of several, those that are no C file.
special() {
    file=$case/work/2.1/nearest-pair.c
    mkdir -p "$case/work/2.1"
    case $1 in
    missing)
        echo x >"$case/work/2.1/main.c"
        expect 0 "There is no nearest-pair.c among what you handed in: main.c" ;;
    nothing-at-all)
        rm -r "$case/work/2.1" && expect 0 "nothing was handed in" ;;
    two-copies)
        mkdir "$case/work/anna" "$case/work/bob"
        cp $solution "$case/work/anna/nearest-pair.c"
        cp $solution "$case/work/bob/nearest-pair.c"
        expect 2 "More than one nearest-pair.c" ;;
    a-link)
        ln -s "$PWD/$solution" "$file"
        expect 0 "no ordinary file" ;;
    a-folder)
        mkdir "$file"
        expect 0 "no ordinary file" ;;
    a-pipe)
        mkfifo "$file"
        expect 0 "no ordinary file" ;;
    includes-a-pipe)
        mkfifo "$case/work/2.1/mine.h"
        echo '#include "mine.h"' >"$file"
        expect 0 "it does not compile" ;;
    shows-the-solution)
        printf '#line 1 "%s"\n#error\n' "$PWD/$solution" >"$file"
        expect 0 "it does not compile"
        echo "The nearest pair of all" >>"$case/expected" ;;
    includes-the-tests)
        printf '#include "%s"\n' "$PWD/exercises/ch02/1-nearest-pair/tests.c" >"$file"
        expect 0 "it " ;;
    larger-than-life)
        head -c 2000000 /dev/zero | tr '\0' ' ' >"$file"
        expect 0 "it is larger than a megabyte" ;;
    crowded)
        for number in $(seq 101); do : >"$case/work/2.1/$number.h"; done
        cp $solution "$file"
        expect 0 "more than a hundred files" ;;
    includes-a-link)
        ln -s "$PWD/$solution" "$case/work/2.1/mine.h"
        echo '#include "mine.h"' >"$file"
        expect 0 "it does not compile" ;;
    binary)
        head -c 20000 "$BUILD/kit/results" >"$file"
        expect 0 "it does not compile" ;;
    odd-names)
        for name in '-rf' '$(touch hostile-was-here).c' 'a b;c.c' '"\'; do
            echo x >"$case/work/2.1/$name"
        done
        mkdir "$case/work/-n x\$(touch hostile-was-here)\`"
        cp $solution "$case/work/-n x\$(touch hostile-was-here)\`/nearest-pair.c"
        rm -r "$case/work/2.1"
        expect 2 "" ;;
    esac
}
specials="missing nothing-at-all a-link a-folder a-pipe two-copies includes-a-link
    includes-a-pipe includes-the-tests shows-the-solution larger-than-life crowded
    binary odd-names"

if [ "$1" = --one ]; then
    folder=$2 name=$3
    case=$folder/$name
    mkdir -p "$case/work"
    file=$here/hostile/${name%.limits}.c
    if [ -f "$file" ]; then
        # shellcheck disable=SC2046 # three words
        set -- $(sed -n 's,^// exercise: ,,p' "$file")
        EXERCISES=${1:-2.1} TEST=${3:-ties}
        mkdir "$case/work/$EXERCISES"
        cp "$file" "$case/work/$EXERCISES/${2:-nearest-pair}.c"
        cp $here/hostile/right.h "$case/work/$EXERCISES"
        expect "$(sed -n '2s/.*score: //p' "$file")" \
            "$(sed -n '3s/.*says: //p' "$file")"
        sed -n 's,^// never: ,,p' "$file" >>"$case/expected"
    else
        special "$name"
    fi
    # Only what never ends is not given time.
    grep -q '^no answer after' "$case/expected" || LIMIT=10
    # What is left where the system has no rules to offer.
    [ "$name" = "${name%.limits}" ] || export KIT_RULES=no
    [ "$name" != fork-bomb.limits ] || expect any "" # it may be slow
    WORK=$case/work GRADES=$case/grade exercises/kit/grade \
        >"$case/said" 2>"$case/errors"
    echo $? >"$case/status"
    exit 0
fi

folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder" hostile-was-here' EXIT
chmod 755 "$folder"
if [ $# -eq 0 ]; then
    # shellcheck disable=SC2046 # names have no spaces
    set -- $(cd $here/hostile && ls ./*.c | sed 's,^\./,,; s,\.c$,,') $specials \
        leaves-children.limits fork-bomb.limits endless-loop.limits \
        exits.limits output-flood.limits
fi
# What a fence holds back elsewhere is seen where there is none.
make -s -f exercises/kit/kit.mk "$BUILD/kit/seal" || exit 1
"$BUILD/kit/seal" || set -- $(printf '%s\n' "$@" | grep -v -e '-a-file$')
# Built once, not by all of them at the same time.
for goal in sanitized/ch02/1-nearest-pair/grader \
    optimized/ch02/1-nearest-pair/grader results; do
    make -s -f exercises/kit/kit.mk "$BUILD/kit/$goal" || exit 1
done
jobs=$(getconf _NPROCESSORS_ONLN) || jobs=1
printf '%s\n' "$@" | xargs -n 1 -P "$jobs" "$0" --one "$folder"
texlua $here/read.lua "$folder" "$@"

if [ -e hostile-was-here ]; then
    echo "not ok nothing is written: hostile-was-here"
else
    echo "ok nothing is written"
fi
if grep -q near-leftover /proc/[0-9]*/comm 2>/dev/null; then
    echo "not ok nobody is left: $(grep -l near-leftover /proc/[0-9]*/comm)"
else
    echo "ok nobody is left"
fi
