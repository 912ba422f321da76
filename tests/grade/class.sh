#!/bin/sh
# A class: folders, archives and names as learning platforms make them,
# hostile archives, what cannot be understood, and the table of all.

: "${BUILD:=build}" "${CC:=cc}"
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
said=said
. tests/checks
make_exercise "$folder" 3-half-of-it
unset EXERCISES CLASS WORK GRADES SEED NOTE WHY TEST
export BUILD=build CC

cat >"$exercise/exercise.md" <<'END'
---
title: Half of it
points: 10
---
END
cat >"$exercise/exercise.h" <<'END'
#pragma once
int half(int n);
END
cat >"$exercise/tests.c" <<'END'
#include "exercise.h"
#include "kit.h"

static void check(int n)
{
    int *found = kit_output("the half", 1, sizeof *found);
    CALL(*found = STUDENT(half)(n));
    if (*found != n / 2)
        WRONG(.found = kit_text("%d", *found));
}

static void even(uint64_t seed)
{
    (void)seed;
    check(8);
}

static void odd(uint64_t seed)
{
    (void)seed;
    check(9);
}

const struct kit_test kit_tests[] = {
    {"even", 3, "an even number", even},
    {"odd", 7, "an odd number", odd},
    {0},
};
END
right='#include "exercise.h"
int half(int n) { return n / 2; }'
source=half-of-it.c
class=class
mkdir $class
put() {
    mkdir -p "$(dirname "$class/$1")" && printf '%s\n' "$2" >"$class/$1"
}

# ---- what a class hands in -----------------------------------------------
put "anna/$source" "$right"
put "ben/work/98.3/$source" '#include "exercise.h"
int half(int n) { return (n + 1) / 2; }'
put "Müller, Jörg_17_assignsubmission_file_/$source" "$right"
put "Li, Ann_18_assignsubmission_file_/$source" "$right"
put "Li, Ann_19_assignsubmission_file_/$source" 'int x = ;'
put "Noe, Zoe_20_assignsubmission_file_half-of-it.c" "$right"
put "curiema_123_4567_half-of-it-1.c" "$right"
put "noether_LATE_124_4568_$source" "$right"
put "dan/half-of-it (1).c" "$right"
put "kim/half_of_it.c" "$right"
mkdir $class/nobody
put "Bo_21_assignsubmission_onlinetext_/onlinetext.html" hello
put notes.txt hello
put '=1+1/half-of-it.c' "$right"
mkdir -p zipped/work/98.3
printf '%s\n' "$right" >zipped/work/98.3/$source
(cd zipped && ln -s /etc/passwd link && zip -q -y -r ../right.zip .)
mkdir $class/eva
cp right.zip "$class/eva/my [best] work.ZIP"
cp right.zip $class/frank.zip
cp right.zip $class/turing_125_4569_work.zip

exercises=98.3
CLASS=$class EXERCISES=$exercises exercises/kit/grade >said 2>&1
check "a class is graded" [ $? -eq 0 ]
cp said table
cp build/grades/class.csv csv
has() {
    cp csv said
    check "$1" grep -q -x -F -e "$2" csv
}
has "the table's head" 'student,exercise,points,of,worst'
has "a folder" '"anna",98.3,10,10,""'
has "a wrong answer, and the test that cost most" '"ben",98.3,3,10,"an odd number: wrong"'
has "Moodle's folder" '"Müller, Jörg",98.3,10,10,""'
has "one of a name" '"Li, Ann (18)",98.3,10,10,""'
has "another of that name" '"Li, Ann (19)",98.3,0,10,"does not compile"'
has "Moodle's file" '"Noe, Zoe",98.3,10,10,""'
has "Canvas's file" '"curiema",98.3,10,10,""'
has "Canvas's file that came late" '"noether",98.3,10,10,""'
has "a browser's name" '"dan",98.3,10,10,""'
has "a misspelled name" \
    '"kim",98.3,0,10,"There is no half-of-it.c among what you handed in: half_of_it.c"'
has "nothing" '"nobody",98.3,0,10,"There is no half-of-it.c: nothing was handed in"'
has "an archive in a folder" '"eva",98.3,10,10,""'
has "an archive with a student's name" '"frank",98.3,10,10,""'
has "Canvas's archive" '"turing",98.3,10,10,""'
has "no formula" "\"'=1+1\",98.3,10,10,\"\""
check "each has a row" [ "$(wc -l <csv)" -eq 16 ]
cp table said
check "who is not understood is said" says "kim: no file has the name"
check "and nobody" says "nobody: no file has the name"
check "and what is no student's" says "notes.txt: a file with no student's name"
check "and what is not of files" says "Bo_21_assignsubmission_onlinetext_: Moodle's"
check "the table is shown" grep -q '^ben  *3  *3$' said
check "with what was lost" says "98.3  an odd number: wrong"
check "and where it is" says "build/grades/class.csv"
check "results lie beside it" [ -s "build/grades/Müller, Jörg/results.json" ]
check "what was handed in is as it was" [ "$(ls $class/eva)" = "my [best] work.ZIP" ]
find build/grades/eva -type l >said
check "an archive's links are gone" [ ! -s said ]
mkdir -p two/anna two/kim
cp $class/anna/* two/anna
cp $class/kim/* two/kim
CLASS=two exercises/kit/grade >said 2>&1
check "without EXERCISES, what anybody handed in" says "anybody handed in, 98.3"

# ---- what is refused -------------------------------------------------------
# refused NAME WORDS VARIABLES...: status 2
refused() {
    what=$1 words=$2
    shift 2
    env "$@" exercises/kit/grade >said 2>&1
    status=$?
    check "$what" refused_with "$words"
}
refused_with() {
    says "$1" && [ $status -eq 2 ]
}
mkdir -p one/98.3 empty stray/kim
cp $class/anna/$source one/98.3
cp $class/kim/* stray/kim
refused "a student for a class" "say WORK=one" CLASS=one
refused "no class" "there is no folder no" CLASS=no
refused "an archive for a class" "unpack right.zip first" CLASS=right.zip
refused "an empty class" "empty is empty" CLASS=empty
refused "a class without a name that is known" "nobody in stray" CLASS=stray
refused "a class for a student" "or a class, with CLASS=class" WORK=$class
refused "a student's folder without such a name" "half_of_it.c" WORK=stray/kim
check "which is not 0 of 0" lacks '0 / 0\|scores'

# ---- archives that want to harm ---------------------------------------------
# archive NAME WORDS: one student's, in bad.zip
archive() {
    rm -rf bad
    mkdir bad
    mv bad.zip bad
    WORK=bad EXERCISES=98.3 exercises/kit/grade >said 2>&1
    check "$1" says "$2"
}
lost='"98.3": 0.00'
mkdir many
(cd many && seq 2500 | xargs touch && zip -q -r ../bad.zip .)
archive "too many files" "could not be unpacked"
head -c 60000000 /dev/zero >large.c
zip -q bad.zip large.c
archive "too large" "could not be unpacked"
check "and it was not" [ ! -e build/grade/work/bad.zip.unpacked ]
echo nonsense >bad.zip
archive "no archive" "could not be unpacked"
check "and its points are lost" says "$lost"
mkdir -p deep/a
cp $class/anna/$source deep/$source
(cd deep/a && zip -q ../../bad.zip ../$source)
archive "names that lead out" '"98.3": 10.00'
find build/grade/work -name $source >said
check "stay in" grep -q 'work/bad.zip.unpacked/' said
ln -s "$folder/one" door
zip -q -y bad.zip door
rm door
archive "a link as a door" "$lost"
rm -rf bad door
zip -q -e -P secret bad.zip $class/anna/$source
archive "a password" "could not be unpacked"
