#!/bin/sh
# What the exercises as a whole must be: at least 75, at least 48 of them
# programmed, some for five minutes' walk and some for a week,
# of every number of stars, in each chapter at least five.
texts=$(ls exercises/ch*/*/exercise.md)
all=$(echo "$texts" | wc -l)
programmed=$(ls exercises/ch*/*/solution.c | wc -l)

check() {
    if [ "$2" "$3" "$4" ]; then
        echo "ok $1: $2"
    else
        echo "not ok $1: $2"
    fi
}

with() {
    grep -l "^$1\$" $texts | wc -l
}

check "exercises" "$all" -ge 75
check "programmed" "$programmed" -ge 48
check "of at most 20 minutes" "$(with 'minutes: \([0-9]\|1[0-9]\|20\)')" -ge 5
check "of a week" "$(with 'minutes: \([0-9]\|1[0-9]\|20\)')" -ge 2
for stars in 1 2 3 4 5; do
    check "with $stars stars" "$(with "stars: $stars")" -ge 2
done
for chapter in exercises/ch*; do
    check "of $chapter" "$(ls -d "$chapter"/*/ | wc -l)" -ge 5
done
