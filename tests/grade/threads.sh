#!/bin/sh
# How many threads did the work, in an exercise made for this: a serial
# answer, turns in a critical region, threads that only exist, and the
# check of naive files, of which the serial answer is one.

: "${BUILD:=build}" "${CC:=cc}"
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
said=said
. tests/checks
make_exercise "$folder" 2-threads
export BUILD=build CC

cat >"$exercise/exercise.md" <<'END'
---
title: Threads
points: 10
---
END
cat >"$exercise/exercise.h" <<'END'
#pragma once
int weigh(int i);
int weigh_all(int n, int threads);
END
cat >"$exercise/tests.c" <<'END'
#include "exercise.h"
#include "kit.h"

static int asked;

int weigh(int i)
{
    kit_at_work(asked);
    return i;
}

static void check(int threads)
{
    enum { N = 64 };
    int *sum = kit_output("the sum", 1, sizeof *sum);
    asked = threads;
    CALL(*sum = STUDENT(weigh_all)(N, threads));
    if (*sum != N * (N - 1) / 2)
        WRONG(.found = kit_text("%d", *sum));
    kit_expect_threads(threads);
    kit_next_case();
}

static void one(uint64_t seed)
{
    (void)seed;
    check(1);
}

static void several(uint64_t seed)
{
    (void)seed;
    for (int threads = 2; threads <= 8; threads++)
        check(threads);
}

const struct kit_test kit_tests[] = {
    {"one", 2, "one thread", one},
    {"several", 8, "several threads", several},
    {0},
};
END

# hand_in NAME POINTS WORDS BODY: what one way to do it earns
hand_in() {
    mkdir -p work/98.2
    {
        echo '#include "exercise.h"'
        echo "int weigh_all(int n, int threads) { int sum = 0; $4"
        echo 'return sum; }'
    } >work/98.2/threads.c
    exercises/kit/grade >said 2>&1
    check "$1: $2 points" grep -q "^  98.2 .* $2 / 10\$" said
    tr -s ' \n' ' ' <build/grade/98.2/report.txt >said
    check "$1: it is told" grep -q -F "$3" said
}

loop='for (int i = 0; i < n; i++) sum += weigh(i);'
hand_in "shared work" 10 "10 / 10" "
_Pragma(\"omp parallel for num_threads(threads) reduction(+ : sum)\")
$loop"
hand_in "a serial loop" 2 "one thread did all the work" "
(void)threads; $loop"
hand_in "a region that does nothing" 2 "one thread did all the work" "
volatile int idle = 0;
_Pragma(\"omp parallel num_threads(threads)\")
{ idle; }
$loop"
hand_in "one for all" 2 "one thread did all the work" "
_Pragma(\"omp parallel num_threads(threads)\")
_Pragma(\"omp single\")
$loop"
hand_in "turns in a critical region" 2 "one thread did all the work" "
_Pragma(\"omp parallel for num_threads(threads)\")
for (int i = 0; i < n; i++)
_Pragma(\"omp critical\")
sum += weigh(i);"
hand_in "more threads than asked for" 2 "16 threads" "
(void)threads;
_Pragma(\"omp parallel for num_threads(16) reduction(+ : sum) schedule(static, 1)\")
$loop"

# ---- naive files -------------------------------------------------------
# naive NAME WORDS EXPECT LESSON: what the check says of the serial loop
naive() {
    {
        printf '// Adds it up alone.\n%s\n%s\n' "$3" "$4"
        echo '#include "exercise.h"'
        echo "int weigh_all(int n, int threads) { int sum = 0; (void)threads; $loop"
        echo 'return sum; }'
    } >"$exercise/naive.c"
    exercises/kit/check naive ch98/2-threads >said 2>&1
    check "naive: $1" grep -q -e "$2" said
}
make -s -f exercises/kit/kit.mk build/kit/optimized/ch98/2-threads/grader
mkdir -p build/kit/ch98/2-threads
naive "its score" '^ok ' '// expect: 2 of 10' ''
naive "another score" '^not ok .*has 2 points, not 3' '// expect: 3 of 10' ''
naive "no score" '^not ok .*second line' '' ''
naive "of other points" '^not ok .*the text says 10' '// expect: 2 of 8' ''
naive "too many points" '^not ok .*more than 40 %' '// expect: 5 of 10' ''
naive "many, if that is the lesson" '^not ok .*has 2 points, not 5' \
    '// expect: 5 of 10' '// lesson: the answer'
