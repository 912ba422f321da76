#!/bin/sh
# What a student reads of an exercise, its task and all its hints, names
# other exercises, figures and sections as the book does: no label of
# the sources is left.

place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
BUILD=$place # where the number of hints that were shown is kept
said=$place/said
. tests/checks
. exercises/kit/common.sh

reads() { grep -q -E -x -e "$1" "$said"; }

resolve() {
    echo "$1" | awk -f exercises/kit/references.awk >"$said"
}

# The numbers themselves are held to the press's by tests/manual.
resolve 'Zagha [-@zagha1991], @ex:ch06-unpack; @ch:ch06. In @sec:triangle:'
check "an exercise, a chapter, a section and a citation" \
    reads 'Zagha, Exercise 6\.2; Chapter 6\. In Section 3\.[0-9]+:'
resolve '@fig:ch03-turn (@tab:ch03-turns), @ch:appendix-intrinsics'
check "a figure, a table and an appendix" \
    reads 'Figure 3\.[0-9]+ \(Table 3\.[0-9]+\), Appendix [A-Z]'
resolve 'as @ex:ch06-no-such'
check "what there is not stays as it is" says 'as @ex:ch06-no-such'

for text in exercises/ch*/*/exercise.md; do
    {
        awk -f $kit/task.awk "$text"
        sed -n '/^::: *hint/,/^::: *$/p' "$text"
    } | plain >"$said"
    check "$text names what it refers to" lacks '@[a-z]'
done

find_exercise 5.6
put_task >"$said"
check "so does task.md" says 'Exercise 5.5'
exercises/kit/hint 5.7 >"$said"
exercises/kit/hint 5.7 >>"$said"
check "and make hint5.7" says 'Exercise 5.5'

# ---- formulas ------------------------------------------------------------
while read -r tex plain; do
    printf 'Of $%s$.\n' "$tex" | tr '~' ' ' | awk -f exercises/kit/formulas.awk >"$said"
    check "a formula: $plain" reads "Of $(printf '%s' "$plain" | tr '~' ' ' | sed 's/[()^+*.|]/\\&/g')\\."
done <<'END'
2^{-24} 2^-24
2^{2k} 2^(2k)
n~\log~n n~log~n
O(\sqrt~N) O(sqrt(N))
(\sqrt{8m+1}~-~1)/2 (sqrt(8m+1)~-~1)/2
t~\le~m t~<=~m
2\lceil\log_2~n\rceil 2~ceil(log_2~n)
e^{-c\pi~t^2} e^(-c~pi~t^2)
\mathit{low}~\ge~0 low~>=~0
END
echo 'The `a$b` and `$x$` stay, and so does 3 $ and 4 $.' >"$place/dollars"
awk -f exercises/kit/formulas.awk "$place/dollars" >"$said"
check "code and prices stay" cmp -s "$place/dollars" "$said"
