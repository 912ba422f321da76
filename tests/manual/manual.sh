#!/bin/sh
# The instructor's manual: it has no fault, the numbers that it gives to
# the book's figures are those of the exercises' kit, and every command
# that it shows in a lecture says something and complains of nothing, in
# its quick form where it has one.
: "${BUILD:=build}" "${CC:=cc}"
unset MAKEFLAGS MFLAGS MAKELEVEL

said=$(texlua book/press/press.lua --solutions --check --build "$BUILD" 2>&1) &&
    echo "ok the manual has no fault" ||
    echo "not ok the manual: $(echo "$said" | head -n 1)"

# A student's kit has no press, and counts by itself what the book numbers.
sed -n 's/^\\booknumber{\([^}]*\)}{\(.*\)}$/@\1 \2/p' "$BUILD/solutions/book.tex" |
    awk -f exercises/kit/references.awk |
    awk '$2 != $3 { wrong = wrong " " $0 ";" }
        END {
            if (wrong != "" || NR < 300)
                print "not ok the kit numbers as the press does, of " NR ":" wrong
            else
                print "ok the kit numbers as the press does"
        }'

errors=$(mktemp) || exit 1
trap 'rm -f "$errors"' EXIT
trap 'exit 1' HUP INT TERM

# The lines of the blocks "demo", or what is to be run in their place.
awk '/^```/ {
         demo = !demo && /^``` *\{?\.?demo/
         if (demo && match($0, /quick="[^"]*"/)) {
             print substr($0, RSTART + 7, RLENGTH - 8)
             demo = 0
         }
         next
     }
     demo' book/manual/*.md | sort -u |
    while IFS= read -r command; do
        here=$(printf '%s\n' "$command" | sed "s|build/|$BUILD/|g")
        if [ -n "$(timeout 60 sh -c "$here" 2>"$errors")" ] &&
            [ ! -s "$errors" ]; then
            echo "ok $command"
        else
            echo "not ok $command: $(tail -n 1 "$errors")"
        fi
    done
