#!/bin/sh
# The numbers in README.md are those of book/data.
root=$(cd "$(dirname "$0")/../.." && pwd)
data=$root/book/data/ch10-journey.tsv
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

readme() { texlua "$root/book/press/readme.lua" "$@" 2>"$scratch/said"; }

# verdict NAME EXPECTED FOUND
verdict() {
    if [ "$2" = "$3" ]; then
        echo "ok $1"
    else
        echo "not ok $1: expected status $2, found $3: $(cat "$scratch/said")"
    fi
}

readme --check "$root/README.md" "$data"
verdict 'README.md says what was measured; if not, make readme' 0 $?

# A number changed by hand is found, and one that is measured anew.
sed "/^| \`tiles\`/s/[0-9]/&7/" "$root/README.md" >"$scratch/README.md"
readme --check "$scratch/README.md" "$data"
verdict 'a number changed by hand' 1 $?
sed '/^tiles	/s/	\([1-9]\)/	3\1/g' "$data" >"$scratch/ch10-journey.tsv"
readme --check "$root/README.md" "$scratch/ch10-journey.tsv"
verdict 'a number measured anew' 1 $?

# The table mends itself, twice with the same result.
readme "$scratch/README.md" "$data"
verdict 'a table written' 0 $?
cmp -s "$root/README.md" "$scratch/README.md"
verdict 'is what it was' 0 $?
grep -v 'The journey' "$root/README.md" >"$scratch/README.md"
readme "$scratch/README.md" "$data"
verdict 'a README without a place for it' 1 $?

# Elsewhere in it no number looks measured.
cat >"$scratch/numbers.lua" <<'END'
package.path = arg[1] .. "/book/press/?.lua;" .. package.path
local numbers, files = require "numbers", require "files"
local there = false
for _, line in ipairs(files.lines(arg[1] .. "/README.md")) do
  there = line:match("^<!%-%- The journey:") and true
    or there and not line:match("^<!%-%- The journey ends")
  if not there and not line:match("^    ") then
    for _, found in ipairs(numbers.suspicious((line:gsub("`[^`]*`", ""):gsub("CC BY %S+", "")))) do
      print(found)
    end
  end
end
END
texlua "$scratch/numbers.lua" "$root" >"$scratch/said" 2>&1
verdict 'no other number looks measured' 0 "$(wc -l <"$scratch/said" | tr -d ' ')"
