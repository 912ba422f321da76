#!/bin/sh
# make watch2.1: a failure, files that are saved, and the next exercise.

: "${BUILD:=build}"
export BUILD
folder=$(mktemp -d) || exit 1
WORK=$folder/work PAUSE=0.1 TEST=same-place
export WORK PAUSE TEST
said=$folder/said
mkdir -p "$WORK"
exercises/kit/watch 2.1 >"$said" 2>&1 &
watch=$!
trap 'kill $watch 2>/dev/null; rm -rf "$folder" "$BUILD/$folder"' EXIT

# comes NAME WORDS: within a minute
comes() {
    tries=0
    while ! grep -q -e "$2" "$said" && [ $tries -lt 600 ]; do
        sleep 0.1
        tries=$((tries + 1))
    done
    if grep -q -e "$2" "$said"; then
        echo "ok $1"
    else
        echo "not ok $1: $(tail -n 5 "$said" | tr '\n' ' ')"
    fi
}

# saves TEXT: in one step, as editors do
saves() {
    printf '%s\n' "$1" >"$folder/new"
    mv "$folder/new" "$WORK/2.1/nearest-pair.c"
}

comes "it waits" 'Waiting until .*nearest-pair.c is saved'
saves 'int x = ;'
comes "a file that is saved is tried" 'does not compile'
[ "$(grep -c Waiting "$said")" -le 2 ] && echo "ok and nothing else" ||
    echo "not ok and nothing else: $(grep -c Waiting "$said") times"
saves "$(cat exercises/ch02/1-nearest-pair/solution.c)"
comes "what has all its points is done" '2.1 is done; the next one is'
comes "the next one begins" '^Made .*/2\.[2-9]/'
exercises/kit/watch 2.5 >"$folder/paper" 2>&1
[ $? -eq 2 ] && echo "ok on paper there is nothing to watch" ||
    echo "not ok on paper: $(cat "$folder/paper")"
