#!/bin/sh
# The press's own tests, without LaTeX. Takes the small book good/ as it
# is; then once with each fault of faults/*.sed, whose first line names
# the file it spoils and whose second the beginning of a message that
# must stop the press; if the third is "# solutions", it must stop the
# instructor's manual. Ends with the tests of modules.lua.
here=$(cd "$(dirname "$0")" && pwd)
press=$here/../../book/press
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM

# A fresh copy of the small book.
book() {
    cp -R "$here/good" "$1" && mkdir -p "$1/build/figures" &&
        : >"$1/build/figures/ch01-speed.pdf"
}

# check FOLDER [--solutions]
check() {
    texlua "$press/press.lua" $2 --check --root "$1" >"$1/said" 2>&1
}

test_good() {
    book "$scratch/good"
    if check "$scratch/good" && [ ! -s "$scratch/good/said" ]; then
        echo "ok good"
    else
        printf 'not ok good: %s\n' "$(head -n 1 "$scratch/good/said")"
    fi
}

# What a LaTeX file must hold: words, one a line.
holds() {
    while IFS= read -r words; do
        if grep -qF -e "$words" "$1"; then
            printf 'ok printed: %s\n' "$words"
        else
            printf 'not ok printed: no %s\n' "$words"
        fi
    done <"$2"
}

# The instructor's manual has what the book has not.
test_solutions() {
    if check "$scratch/good" --solutions && [ ! -s "$scratch/good/said" ]; then
        echo "ok solutions"
    else
        printf 'not ok solutions: %s\n' "$(head -n 1 "$scratch/good/said")"
    fi
    holds "$scratch/good/build/solutions/book.tex" "$here/printed-solutions"
}

test_printed() {
    holds "$scratch/good/build/book/book.tex" "$here/printed"
    for words in 'Look at the comparison' 'It computes' 'A later tie' \
        'Everybody gets'; do
        if grep -qF "$words" "$scratch/good/build/book/book.tex"; then
            echo "not ok printed: what the book keeps back, $words"
        else
            echo "ok not printed: $words"
        fi
    done
}

# A claim that does not hold is said and printed, and stops nothing.
test_claim() {
    place=$scratch/claim
    book "$place"
    sed -i.bak '20s/10 < ch01/10 > ch01/' "$place/chapters/ch01-near.md"
    expect='chapters/ch01-near.md:20: note: on this machine it does not hold'
    if ! check "$place"; then
        echo "not ok claim: it stops the press"
    elif ! grep -q "^$expect" "$place/said"; then
        printf 'not ok claim: the press said %s\n' "$(cat "$place/said")"
    elif ! grep -qF 'nine.\doesnothold{}' "$place/build/book/book.tex"; then
        echo "not ok claim: the book does not say it"
    else
        echo "ok claim"
    fi
}

test_fault() {
    name=$(basename "$1" .sed)
    place=$scratch/$name
    file=$(sed -n '1s/^# //p' "$1")
    expect=$(sed -n '2s/^# expect: //p' "$1")
    book "$place"
    sed -f "$1" "$here/good/$file" >"$place/$file"
    kind=$(sed -n '3s/^# solutions$/--solutions/p' "$1")
    check "$place" $kind
    status=$?
    if cmp -s "$here/good/$file" "$place/$file" || [ -z "$expect" ]; then
        echo "not ok fault $name: there is no fault"
    elif [ $status -ne 1 ]; then
        echo "not ok fault $name: status $status, not 1"
    elif ! awk -v expect="$expect" 'index($0, expect) == 1 { found = 1 }
            END { exit !found }' "$place/said"; then
        printf 'not ok fault %s: the press said %s\n' "$name" \
            "$(head -n 1 "$place/said")"
    else
        echo "ok fault $name"
    fi
    rm -rf "$place"
}

# Where LaTeX stops at an error, the press says where, and takes no book
# that an earlier run left for this one's.
test_stopped() {
    place=$scratch/stopped
    book "$place"
    mkdir -p "$place/bin" "$place/build/book"
    cat >"$place/bin/lualatex" <<'END'
#!/bin/sh
cat >book.log <<'LOG'
@@chapters/ch01-near.md:19
LaTeX Warning: Reference `sec:cost' on page 1 undefined on input line 9.
@@chapters/ch01-near.md:20
! Undefined control sequence.
LOG
exit 1
END
    chmod +x "$place/bin/lualatex"
    expect='chapters/ch01-near.md:20: LaTeX says: Undefined control sequence.'
    for mode in "" --draft; do
        echo old >"$place/build/book/book.pdf"
        PATH=$place/bin:$PATH texlua "$press/press.lua" $mode \
            --root "$place" >"$place/said" 2>&1
        status=$?
        if [ $status -ne 1 ] || [ "$(head -n 1 "$place/said")" != "$expect" ] ||
            [ "$(wc -l <"$place/said")" -ne 2 ]; then
            printf 'not ok stopped %s: status %s, the press said %s\n' \
                "$mode" $status "$(cat "$place/said")"
        elif [ -e "$place/build/draft.pdf" ] ||
            [ -e "$place/build/near-and-far.pdf" ]; then
            echo "not ok stopped $mode: there is a book"
        else
            echo "ok stopped $mode"
        fi
    done
}

test_good
test_printed
test_solutions
test_claim
test_stopped
running=0
for fault in "$here"/faults/*.sed; do
    test_fault "$fault" >"$scratch/$(basename "$fault").result" &
    running=$((running + 1))
    [ $((running % 4)) -ne 0 ] || wait
done
wait
cat "$scratch"/*.result
texlua "$here/modules.lua" "$press" "$here"
