#!/usr/bin/env bash
# Every line with which a chapter says that a program compiles by itself
# compiles it. Without optimization, which would take its time and find
# nothing; and what several lines compile, with the same words, only
# once. A chapter without such a line is a fault.
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root" || exit 1
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

# compile WORD...: what a line says, for words as the shell expands them,
# by way of an object for each source.
compile() {
    local options=() sources=() rest=() word object
    for word; do
        case $word in
        *.c) sources+=("$word") ;;
        -l*) rest+=("$word") ;;
        *) options+=("$word") ;;
        esac
    done
    for word in "${sources[@]}"; do
        object=$(cksum <<<"${options[*]} $word")
        object=$scratch/${object%% *}.o
        [ -f "$object" ] ||
            "${options[@]}" -c "$word" -o "$object" || return
        rest=("$object" "${rest[@]}")
    done
    "${options[@]}" "${rest[@]}" -o "$scratch/$program"
}

for chapter in chapters/ch*.md; do
    name=$(basename "$chapter" .md)
    if ! grep -q '^    cc -std' "$chapter"; then
        echo "not ok $name: prints no line that compiles a program of it"
        continue
    fi
    line=$(awk '/^    cc -std/ { there = 1 }
        there { more = sub(/\\$/, ""); printf "%s ", $0 }
        there && !more { exit }' "$chapter")
    program=$(sed 's/.* -o \([a-z-]*\) .*/\1/' <<<"$line")
    line=${line/ cc / ${CC:-cc} }
    line=${line/ -O3 / -O0 }
    line=${line/ -o $program / }
    if ! eval "compile $line" >"$scratch/said" 2>&1; then
        echo "not ok $name: $program: $(grep -m 1 . "$scratch/said")"
    elif ! [ -x "${BUILD:-build}/${name%%-*}/$program" ]; then
        echo "not ok $name: make builds no $program"
    else
        echo "ok $name: $program"
    fi
done
