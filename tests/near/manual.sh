#!/bin/sh
# The manual tells of every option and of nothing else, and what it
# tells can be done.
source=$(realpath "$(dirname "$0")/../../code")
. "$(dirname "$0")/checks"

accepts '--help' --help
cp "$out" manual
says 'fits a terminal' '' "$(awk 'length > 79' manual)"
says 'is plain text' '' "$(LC_ALL=C grep -n '[^ -~]' manual)"

# The options as the parser has them, and those that begin a line of the
# manual.
options() {
    sed -n 's/.*{"near", ":\([^"]*\)", names.*/\1/p' \
        "$source/near/options.c" | tr -d ':' | fold -w 1 | sed 's/^/-/'
    echo
    sed -n 's/^ *{"\([a-z-]*\)", [a-z]*_argument,.*/--\1/p' \
        "$source/near/options.c"
}
options | grep . | sort >parsed
sed -n 's/^  \(--*[a-z]*\).*/\1/p' manual | sort >told
says 'every option is told once, and no other' "$(cat parsed)" "$(cat told)"
says 'some options' yes "$([ "$(wc -l <parsed)" -ge 10 ] && echo yes)"
says 'a value where one is needed' "$(sed -n \
    's/^ *{"\([a-z-]*\)", required_argument,.*/--\1/p' \
    "$source/near/options.c" | sort)" \
    "$(sed -n 's/^  \(--[a-z]*\) [A-Z].*/\1/p' manual | sort)"

# Its limits are those that the parser names when they are broken.
limit() { # OPTION BAD-VALUE
    run -n 10 "$1" "$2"
    sed -n 's/.*whole number from \([0-9]*\) to \([0-9]*\),.*/\1 to \2/p' "$err"
}
for option in -n -t -r; do
    range=$(limit $option 0)
    awk -v option="$option" '/^  -/ { here = $1 == option } here' manual |
        tr '\n' ' ' | tr -s ' ' | grep -q "$range" &&
        ok "$option from $range" || not_ok "$option" "not told: $range"
done

# The defaults make no difference.
defaults=$(tr '\n' ' ' <manual | tr -s ' ' |
    grep -o -e '-[dsgr] [A-Z]* [^(]*(default: [a-z0-9]*' |
    sed 's/\(-.\) .*(default: /\1 /' | tr '\n' ' ')
says 'the defaults' '-d uniform -s 1 -g standard -r 1 ' "$defaults"
accepts 'no options' -n 100 -o left.tsv
accepts 'the same said' -n 100 $defaults -o right.tsv
cmp -s left.tsv right.tsv && ok 'the defaults are so' ||
    not_ok 'the defaults are so' 'the files differ'
accepts 'the usual box' -n 100 -g wraparound -o left.tsv
accepts 'the same box' -n 100 -g wraparound --box 0,0,1,1 -o right.tsv
grep -q '(default: 0,0,1,1)' manual && cmp -s left.tsv right.tsv &&
    ok 'the default box' || not_ok 'the default box' 'is another'

# The columns of both tables, in order.
columns() { # the table's title
    awk -v title="$1" 'index($0, title) { there = 1; next }
        there && /^  [a-z]/ { begun = 1; sub(/^  /, ""); sub(/  .*/, ""); print; next }
        begun && /^$/ { exit }' manual | tr -d ' ' | tr ',' '\n'
}
accepts 'a table' -n 10 -o answers.tsv
says 'its columns' "$(head -n 1 answers.tsv | tr '\t' '\n')" "$(columns 'Tabs separate')"
accepts 'a table of times' -n 10 --timing
says 'its columns, too' "$(head -n 1 "$out" | tr '\t' '\n')" "$(columns 'With --timing')"

# The example of a file, as it stands there.
sed -n 's/^                    \([nhm][a-z]*,.*\)/\1/p' manual >example.csv
accepts 'the file in the manual' example.csv --columns 2,3 -o answers.tsv
says 'is read' '12.5 7
3 -0.25' "$(tail -n +2 answers.tsv | cut -f 2,3 | tr '\t' ' ')"

# Every example of a command, with files of these names.
mkdir bin && ln -s "$near" bin/near
printf 'name,x,y\nUlm,4,3\nRom,0,0\nBonn,1,0\n' >named.csv
printf 'x,y\n4,3\n0,0\n1,0\n' >cities.csv
printf '0 0\n359 1 # nearly the same\n180 90\n' >sky.txt
awk '/^EXAMPLES/ { there = 1; next } /^[A-Z]/ { there = 0 }
    there && /^  near / { sub(/^  /, ""); print }' manual >examples
says 'six examples' 6 "$(wc -l <examples | tr -d ' ')"
while read -r example; do
    case $example in
    *--columns*) cp named.csv cities.csv ;;
    esac
    PATH=$PWD/bin:$PATH sh -c "$example" >"$out" 2>"$err" </dev/null
    says "$example" '0 ' "$? $(cat "$err")"
done <examples
says 'the first example wrote its file' 4 "$(wc -l <neighbors.tsv | tr -d ' ')"

# Every status. That of a mistake in near is tested in status.c.
says 'three statuses' '0 1 2' "$(awk '/^EXIT STATUS/ { there = 1 }
    there && /^  [0-9]/ { print $1 }' manual | tr '\n' ' ' | sed 's/ $//')"
accepts 'status 0' -n 10 --check
printf 'x,y\n' >cities.csv
for line in 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do echo "$line,0"; done >>cities.csv
printf '12.5,abc\n' >>cities.csv
refuses 'status 2, in the words of the manual' \
    "$(grep -A 1 'near: cities.csv' manual | tr -s '\n ' '  ' | sed 's/^ near: //; s/ $//')" \
    cities.csv
