#!/bin/sh
# The slides of all chapters have no fault, and each chapter's have what
# a lecture needs; and what a slide cannot hold is told.
root=$(cd "$(dirname "$0")/../.." && pwd)
: "${BUILD:=build}" "${CC:=cc}"
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
cd "$root" || exit 1
mkdir -p "$scratch/build/drawings" "$scratch/build/slides/figures"

# Pictures are looked for, not at.
for picture in book/figures/*.gp; do
    : >"$scratch/build/slides/figures/$(basename "$picture" .gp).pdf"
done
for drawing in book/drawings/*-*.tex; do
    name=$(basename "$drawing" .tex)
    printf '%s\t1\n' "$name" >>"$scratch/build/drawings/${name%%-*}.pages"
done
press() {
    texlua book/press/press.lua --check --slides "$1" \
        --build "$scratch/build" >"$scratch/said" 2>&1
}

press chapters/slides && [ ! -s "$scratch/said" ] &&
    echo "ok the slides of all chapters" ||
    echo "not ok the slides: $(head -n 1 "$scratch/said")"

# least WORDS N FILE: at least so many lines begin with these words.
least() {
    found=$(grep -c "^$1" "$3")
    [ "$found" -ge "$2" ] || missing="$missing $found of $2 \"$1\""
}
for chapter in chapters/ch*.md; do
    id=$(basename "$chapter" | cut -c 1-4) missing=
    file=chapters/slides/$id.md
    least '## ' 18 "$file"
    least '!\[\](' 6 "$file"
    least '::: predict' 3 "$file"
    for part in aims learned exercises fragment; do
        least "\`\`\` $part" 1 "$file"
    done
    [ -z "$missing" ] && echo "ok $id" || echo "not ok $id:$missing"
done

# One file with every fault, and what the press says of each.
title=$(awk '/\/\/>/ { title = $0; sub(/^.*\/\/> */, "", title); lines = 0; next }
    /\/\/</ { if (lines > 15 && title != "") { print title; exit } title = "" }
    { lines++ }' code/ch04-cell-sort/*.c)
cat >"$scratch/ch04.md" <<END
## One

\`\`\` table
tab:ch04-never
\`\`\`

![](ch04-scan)

![](ch04-line)

## Two

It takes 12.5 ns.

![](ch04-never)

\`\`\` fragment
Never written
$title
\`\`\`
END
press "$scratch/ch04.md"
while IFS= read -r words; do
    grep -q -F -e "$words" "$scratch/said" && echo "ok told: $words" ||
        echo "not ok, not told: $words; but $(head -n 1 "$scratch/said")"
done <<END
the chapter has no table tab:ch04-never
a slide has one picture
there is no figure ch04-never
no fragment is called "Never written"
"$title" has
looks like a measurement
END
