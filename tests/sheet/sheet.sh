#!/bin/sh
# An instructor's way, from the choice of exercises to the archives, in
# a copy of the project: what is made, what it does alone in an empty
# folder, what is refused, and that the search for leaks finds some.
# Without LaTeX and pdftotext, a sheet is a file with its source.
root=$(cd "$(dirname "$0")/../.." && pwd)
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
trap 'exit 1' HUP INT TERM
unset EXERCISES TITLE DUE COURSE INSTRUCTOR WORK GRADES SEED LIMIT TEST PDF MAKEFLAGS MFLAGS
said=$place/said
copy=$place/copy
sheets=$copy/build/sheets
mkdir "$place/bin"
cd "$root" || exit 1
. tests/checks
copy_project "$copy"
cd "$copy" || exit 1
BUILD=build
export BUILD

# A press that is quick, and all there is where LaTeX is missing.
cat >"$place/bin/lualatex" <<'END'
#!/bin/sh
: >book.log
: >book.aux
cp book.tex book.pdf
END
printf '#!/bin/sh\ncat "$2"\n' >"$place/bin/pdftotext"
chmod +x "$place/bin/lualatex" "$place/bin/pdftotext"
quickly() {
    PATH=$place/bin:$PATH "$@"
}
if command -v lualatex && command -v pdftotext; then
    really() { "$@"; }
else
    really() { quickly "$@"; }
fi >/dev/null

exercises/kit/list >"$said" 2>&1
check "a list to choose from" grep -q '^4.2 .* 40 min *10  tests *How many' "$said"

by_hand=$(cat exercises/ch04/[15]-*/exercise.md | awk '/^points:/ { n += $2 } END { print n }')

# ---- a sheet ---------------------------------------------------------
EXERCISES="4.1 4.2 4.5" TITLE="Homework 2" DUE="Friday & Monday" \
    COURSE="Algorithms & Machines" INSTRUCTOR="E. Noether" \
    really exercises/course/sheet >"$said" 2>&1
check "a sheet" [ $? -eq 0 ]
check "says who marks what" says "autograder: 10 points; by hand: $by_hand (4.1 and 4.5)"
homework=$sheets/homework-2/homework-2
really pdftotext -q "$homework.pdf" - >"$said" 2>&1
check "its title" says "Homework 2"
check "whose it is" grep -q 'Algorithms .*Machines, E. Noether' "$said"
check "in which chapter to read" grep -q 'Needs .* from Chapter.*4' "$said"
check "when it is due" grep -q 'Friday .*Monday' "$said"
check "what it amounts to" grep -q "3 exercises, $((by_hand + 10)) points" "$said"
check "how paper is handed in" says "are marked by hand"
tr '\n' ' ' <"$said" >"$said.line"
check "which need the book's programs" grep -q 'For 4.5 you need' "$said.line"
check "its texts" says "How many numbers lie between"
check "what is on paper" says "To be marked by hand"
check "how to work" says "make exercise4.2"
check "no hint" lacks "Count something simpler"
check "no answer" lacks "The bins hold"
check "nothing else" [ "$(ls -A "$sheets" "$sheets/homework-2" | tr '\n' ' ')" = \
    "$sheets: homework-2  $sheets/homework-2: homework-2-autograder.zip homework-2.pdf homework-2.tar.gz " ]

EXERCISES="4.1 4.5" \
    TITLE="Data Structures & Algorithms 1: the third homework, on cells" \
    really exercises/course/sheet >"$said" 2>&1
check "a long title, and nothing programmed" says "autograder: 0 points"
EXERCISES="4.2 4.4" \
    TITLE="Algorithms & Data Structures 1, Homework 3: Cells & Counting" \
    quickly exercises/course/sheet >"$said" 2>&1
check "a long title" says "algorithms-data-structures-1-homework-3.tar.gz  for students"
rm -r "$sheets/algorithms"* "$sheets/data"*

# ---- a student's machine: gcc and make, and nothing of the project ---
# Where dpkg tells which commands every Debian has, only these.
plain=$PATH
if command -v dpkg-query >/dev/null; then
    plain=$place/plain
    mkdir "$plain"
    dpkg-query -W -f '${Essential} ${Package}\n' |
        awk '$1 == "yes" { print $2 }' >"$said"
    for file in $(dpkg -L $(cat "$said") gcc binutils make mawk 2>/dev/null |
        grep '^\(/usr\)\?/bin/.') $(command -v cc) $(command -v awk); do
        ln -sf "$file" "$plain"
    done
fi
alone() {
    env -i PATH="$plain" "$@"
}

mkdir "$place/student" && cd "$place/student" && tar xzf "$homework.tar.gz"
alone make -C homework-2 exercise4.2 >"$said" 2>&1
check "the starter fails, but not make" [ $? -eq 0 ]
check "and is told what is wrong" says "expected"
check "its task lies beside it" [ -s homework-2/work/4.2/task.md ]
check "and has few points" grep -q '^ * [0-5] / 10$' "$said"
alone make -C homework-2 hint4.2 >"$said" 2>&1
check "a hint is given" says "how many numbers are less"
alone make -C homework-2 exercise4.1 >"$said" 2>&1
check "on paper too" says "Nine numbers, counted from 0"
alone make -C homework-2 hint9.9 >"$said" 2>&1
check "another exercise is not on the sheet" says "9.9 is not on this sheet"
alone make -C homework-2 help >"$said" 2>&1
check "make help" says "make hint4.2"
ls -R homework-2 >"$said"
check "no solution in it" lacks 'solution\|mutants\|course\|kit/class\|kit/receive'

# ---- the autograder, with one file in a strange folder ---------------
mkdir -p "$place/grader/source" "$place/grader/submission/my work"
cd "$place/grader/source" && unzip -q "$homework-autograder.zip"
cp "$copy/exercises/ch04/2-how-many-between/solution.c" \
    "../submission/my work/how-many-between.c"
ready=build/kit/optimized/ch04/2-how-many-between/grader
if command -v unzip >/dev/null && [ "$plain" != "$PATH" ]; then
    ln -sf "$(command -v unzip)" "$plain"
fi
(cd / && alone "$place/grader/source/setup.sh") >"$said" 2>&1
check "setup.sh compiles the tests" [ -x $ready ]
made=$(date -r $ready +%s.%N)
alone AUTOGRADER="$place/grader" ./run_autograder >"$said" 2>&1
check "the autograder" [ $? -eq 0 ]
check "does not compile them again" [ "$(date -r $ready +%s.%N)" = "$made" ]
echo another >build/machine
check "Autolab's line" [ "$(tail -n 1 "$said")" = '{"scores": {"4.2": 10.00}}' ]
cat >"$place/score.lua" <<'END'
package.path = arg[1] .. "/tests/?.lua;" .. package.path
print(require "json"(io.open(arg[2]):read("a")).score)
END
scored() {
    [ "$(texlua "$place/score.lua" "$root" \
        "$place/grader/results/results.json" 2>&1)" = "$1" ]
}
check "results.json" scored 10.0
alone ./prepare >"$said" 2>&1
check "on another processor they are" [ "$(date -r $ready +%s.%N)" != "$made" ]
cd "$place/grader" && (cd submission && zip -q -r mine.zip "my work" &&
    rm -r "my work") && cd source
alone AUTOGRADER="$place/grader" ./run_autograder >"$said" 2>&1
check "a zip archive is unpacked" scored 10.0
echo nonsense >../submission/mine.zip
alone AUTOGRADER="$place/grader" ./run_autograder >"$said" 2>&1
check "or the student is told" says "could not be unpacked"
check "and that there is no file" grep -q "There is no how-many-between.c among .*mine.zip" \
    "$place/grader/results/results.json"
check "setup.sh has nothing to do" alone ./setup.sh
mv exercises/kit/grade exercises/kit/lost
alone AUTOGRADER="$place/grader" ./run_autograder >"$said" 2>&1
check "an autograder that fails" [ $? -ne 0 ]
check "writes its results all the same" scored 0
cd "$copy" || exit 1

# ---- what is refused -------------------------------------------------
# refused NAME WORDS EXERCISES TITLE: status 2, and nothing is left.
refused() {
    EXERCISES=$3 TITLE=$4 quickly exercises/course/sheet >"$said" 2>&1
    status=$?
    check "$1" left_nothing "$2"
}

left_nothing() {
    says "$1" && [ $status -eq 2 ] && [ "$(ls -A "$sheets")" = homework-2 ]
}

refused "no exercises" 'which exercises?' "" X
refused "no title" "needs a title" 4.2 ""
refused "an unknown exercise" "there is no exercise 4.77" "4.2 4.77" X
refused "a chapter" '"4" is no exercise' "4" X
refused "a star" '"*" is no exercise' "*" X
refused "one exercise twice" "4.2 is named twice" "4.2, 4.2" X
refused "a folder that is there" "homework-2 is there already" 4.2 "HOMEWORK, 2"
refused "a title without letters" "cannot be named after" 4.2 "../.."
cp exercises/ch04/2-how-many-between/solution.c "$place/solution.c"
sed -i.bak 's/look(s) < x/look(s) <= x/' exercises/ch04/2-how-many-between/solution.c
refused "a solution that fails" "the solution of 4.2 has" 4.2 X
cp "$place/solution.c" exercises/ch04/2-how-many-between/solution.c

# ---- leaks -------------------------------------------------------------
# plant NAME: from the standard input, into a file of an archive.
mkdir "$place/planted"
plant() {
    cat >"$place/planted/$1"
}
ch04=exercises/ch04
sed -n '/uint32_t k = bin_of/,/^}/p' "$place/solution.c" | tr -d '\n ' | plant layout.c
sed -n '/uint32_t k = bin_of/,/^}/s,^,// ,p' "$place/solution.c" | plant comment.h
echo 'int f(void) { return a<b ? count_below(bins,b) - count_below(bins,a) : 0; }' |
    plant short.c
sed -n '/^::: answer/,/^:::$/s/^(b)//p' $ch04/1-nine-numbers/exercise.md |
    tr ' ' '\n' | plant answer.txt
cat $ch04/2-how-many-between/mutants/*.sed | sed -n '/^# [^e]/p' | plant mutants.txt
awk -f exercises/kit/starter.awk $ch04/2-how-many-between/solution.c | plant starter.c
(cd "$place" && zip -q -r inner.zip planted && mkdir outer && mv inner.zip outer &&
    tar czf outer.tar.gz outer)
texlua exercises/course/leaks "$place/outer.tar.gz" >"$said" 2>&1
check "leaks end the search with 1" [ $? -eq 1 ]
for leak in layout.c comment.h short.c answer.txt mutants.txt; do
    check "a leak in $leak" says "planted/$leak:"
done
check "a starter is none" lacks 'starter.c'

# ---- the handout -------------------------------------------------------
PDF=$homework.pdf really exercises/course/handout >"$said" 2>&1
check "the handout" [ $? -eq 0 ]
check "has nothing secret" says "nothing secret in"
mkdir "$place/reader" && cd "$place/reader" &&
    tar xzf "$copy/build/handout/near-and-far.tar.gz"
find . -path '*/tests/press' -prune -o -print >"$said"
check "no solution, no mutant, no sheet" \
    lacks 'solution\.c\|mutants\|/course$\|/course/\|book/manual'
check "but the starters" says "4-back-in-order/starter.c"
grep -r '^::: \(answer\|reasoning\|marking\)' near-and-far/exercises >"$said"
check "and no answer" [ ! -s "$said" ]
(cd near-and-far && make help) >"$said" 2>&1
check "its README describes it" grep -q 'exercises/.*text, tests, starter' \
    near-and-far/README.md
check "its make offers no sheets" lacks 'sheet\|handout\|nothing makes'
cd near-and-far && exercises/kit/exercise 4.4 >"$said" 2>&1
check "its exercises run" says "Exercise 4.4: Back in order"
