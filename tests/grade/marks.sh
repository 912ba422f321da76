#!/bin/sh
# Marks by growth and by time: an exercise made for this, whose student
# is its own reference, or slower, or measured where nothing can be.

: "${BUILD:=build}" "${CC:=cc}"
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
said=said
. tests/checks
make_exercise "$folder" 1-marks
mkdir work/98.1
export BUILD=build CC

scores=build/grade/98.1/scores.tsv

cat >"$exercise/exercise.md" <<'END'
---
title: Marks
stars: 1
minutes: 1
points: 14
needs: nothing
trains: nothing
---
END
cat >"$exercise/exercise.h" <<'END'
#pragma once
#include <stdint.h>
uint64_t work(uint64_t n);
END
# Arithmetic that no compiler can leave out or do in vectors.
cat >work/98.1/marks.c <<'END'
#include "exercise.h"
uint64_t work(uint64_t n)
{
    uint64_t state = n;
    for (uint64_t k = 0; k < n; k++)
        state = state * 6364136223846793005u + (state >> 33 | 1);
    return state;
}
END
cat >"$exercise/tests.c" <<'END'
#include "exercise.h"
#include "kit.h"
#include <math.h>

static uint64_t *out;
static int trial;

static uint64_t burn(uint64_t n)
{
    uint64_t state = n;
    for (uint64_t k = 0; k < n; k++)
        state = state * 6364136223846793005u + (state >> 33 | 1);
    return state;
}

enum { N = 20000000 };

static void student(void)
{
    CALL(*out = STUDENT(work)(N));
}

static void same(void)
{
    CALL(*out = burn(N));
}

static void tenth(void)
{
    CALL(*out = burn(N / 10));
}

// Takes longer from one trial to the next, until it is the fourth.
static void moody(void)
{
    static const uint64_t share[] = {27, 9, 3, 1};
    uint64_t n = N / share[trial < 3 ? trial : 3];
    trial++;
    CALL(*out = burn(n));
}

static void grade(void (*reference)(void), int cores)
{
    out = kit_output("out", 1, sizeof *out);
    double ratio = kit_race((struct kit_race){
        .student = student, .reference = reference, .cores = cores});
    kit_bands(ratio, (struct kit_band[]){{3, 2}, {100, 1}, {0, 0}},
              (struct kit_fault){.found = kit_text("%.3g times", ratio)});
}

static void equal(uint64_t seed)
{
    (void)seed;
    grade(same, 1);
}

static void slower(uint64_t seed)
{
    (void)seed;
    grade(tenth, 1);
}

static void noisy(uint64_t seed)
{
    (void)seed;
    grade(moody, 1);
}

static void cores(uint64_t seed)
{
    (void)seed;
    grade(same, 100000);
}

static void band(double power, int points)
{
    double n[5], cost[5];
    for (int k = 0; k < 5; k++) {
        n[k] = 100 << k;
        cost[k] = 7 * pow(n[k], power);
    }
    double slope = kit_growth(5, n, cost);
    kit_bands(slope, (struct kit_band[]){{1.1, points}, {1.6, 1}, {0, 0}},
              (struct kit_fault){.found = kit_text("n to the %.3f", slope)});
}

static void linear(uint64_t seed)
{
    (void)seed;
    band(1, 2);
}

static void between(uint64_t seed)
{
    (void)seed;
    band(1.5, 2);
}

static void square(uint64_t seed)
{
    (void)seed;
    band(2, 2);
}

const struct kit_test kit_tests[] = {
    {"equal", 2, "as fast", equal},
    {"slower", 2, "ten times as slow", slower},
    {"noisy", 2, "on a noisy machine", noisy},
    {"cores", 2, "with too few processors", cores},
    {"linear", 2, "n", linear},
    {"between", 2, "n to the 1.5", between},
    {"square", 2, "n squared", square},
    {0},
};
END

exercises/kit/grade >said 2>&1
graded=$?
cat build/grade/98.1/report.txt >>said
check "marks are given" [ $graded -eq 0 ]
check "all tests were run" grep -q '^square' $scores

# is TEST POINTS OF STATUS WORDS
is() {
    awk -F '\t' -v test="$1" -v points="$2" -v of="$3" -v status="$4" \
        -v words="$5" '$1 == test {
            good = $2 == points && $3 == of && $4 == status &&
                index($10, words) }
        END { exit !good }' $scores
}

# Where the machine is too noisy for times, that is what must be said.
timed() {
    is "$@" || is "$1" 0 0 "not graded" "too noisy"
}
timed_board() {
    is equal 0 0 "not graded" "too noisy" ||
        grep -q '{"name": "98.1 Marks: as fast", "value": [012][.0-9]*, "order": "asc"}' said
}
check "as fast: all points" timed equal 2 2 passed ""
check "slower: some of them" timed slower 1 2 wrong times
check "a noisy machine is told" is noisy 0 0 "not graded" "too noisy"
check "too few processors are told" is cores 0 0 "not graded" "of the 100000"
check "linear growth" is linear 2 2 passed ""
check "faster growth" is between 1 2 wrong "n to the 1.500"
check "too fast" is square 0 2 wrong "n to the 2.000"
check "what is not graded is no loss" awk '
    /"98.1": / { split($0, a, /: /); score = a[3] + 0 }
    END { exit !(score >= 7 && score < 9) }' said
check "nor a failure" grep -q '<skipped message="not graded' build/grade/junit.xml

# ---- the leaderboard -----------------------------------------------------
board() {
    grep -A 9 '"leaderboard": \[' build/grade/results.json
}
check "no place for who is not right" [ -z "$(board)" ]
TEST="equal linear" exercises/kit/grade >said 2>&1
board >said
check "a place for who is" timed_board
