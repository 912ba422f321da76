#!/bin/sh
# What is exported for Canvas and for Moodle: XML that a parser takes,
# every question of the exam and every exercise in it, each question with
# what its kind needs by the format, and nothing of our markup left. And
# the press tells what is wrong with a question.
root=$(cd "$(dirname "$0")/../.." && pwd)
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
trap 'exit 1' HUP INT TERM
cd "$root" || exit 1
said=$place/said
BUILD=$place/build
export BUILD
. tests/checks

exercises/course/export >"$said" 2>&1
check "both are written" [ $? -eq 0 ]
moodle=$BUILD/export/moodle.xml
mkdir "$place/canvas"
(cd "$place/canvas" && unzip -q "$BUILD/export/canvas-qti.zip") >"$said" 2>&1
check "the archive for Canvas unpacks" [ $? -eq 0 ]
xmllint --noout "$moodle" "$place"/canvas/*.xml >"$said" 2>&1
check "all of it is XML" [ $? -eq 0 ]

# counted FILE XPATH: how many there are; both formats without their
# name spaces.
counted() {
    sed 's/ xmlns="[^"]*"//' "$1" >"$place/plain.xml"
    xmllint --xpath "count($2)" "$place/plain.xml" 2>"$said"
}
# same NAME N FILE XPATH: there are just so many.
same() {
    found=$(counted "$3" "$4")
    echo "$found, not $2" >"$said"
    check "$1" [ "$found" = "$2" ]
}

questions=$(cat book/manual/exam/ch*.md | grep -c '^## ')
exercises=$(ls exercises/ch*/*/exercise.md | wc -l)
chapters=$(ls chapters/ch*.md | wc -l)
same "Moodle has all questions" $((questions + exercises)) "$moodle" \
    '/quiz/question[@type!="category"]'
same "in categories" $((2 * chapters)) "$moodle" '/quiz/question[@type="category"]'
same "each has a name, a text and points" 0 "$moodle" '/quiz/question[@type!="category"]
    [not(name/text/text()) or not(questiontext[@format="html"]/text/text()) or not(defaultgrade > 0)]'
same "each choice has one right answer" 0 "$moodle" '/quiz/question[@type="multichoice"]
    [count(answer[@fraction=100]) != 1 or count(answer) < 3 or single != "true"]'
same "each number is one, with its tolerance" 0 "$moodle" '/quiz/question[@type="numerical"]
    [count(answer) != 1 or not(number(answer/text) >= 0) or not(number(answer/tolerance) >= 0)]'
same "each essay says how it is answered" 0 "$moodle" '/quiz/question[@type="essay"]
    [not(responseformat) or attachmentsrequired != attachments or not(responsetemplate)]'
same "exercises are files to hand in" "$((exercises))" "$moodle" \
    '/quiz/question[@type="essay"][attachmentsrequired=1]'

manifest=$place/canvas/imsmanifest.xml
same "Canvas has a file for each" $((2 * chapters)) "$manifest" '//resource[@type="imsqti_xmlv1p2"]'
for file in $(sed -n 's/.*href="\([^"]*\)".*/\1/p' "$manifest"); do
    [ -s "$place/canvas/$file" ] || echo "not ok the manifest names $file"
done
items=0
for file in "$place"/canvas/e*.xml; do
    name=$(basename "$file")
    items=$((items + $(counted "$file" '//item')))
    bad=$(counted "$file" '//item[not(itemmetadata//fieldlabel="question_type") or
        not(presentation/material/mattext/text()) or not(resprocessing/outcomes/decvar)]')
    [ "$bad" = 0 ] || echo "not ok $name: $bad items lack something"
    bad=$(counted "$file" '//item[.//fieldentry="multiple_choice_question"]
        [not(.//response_label/@ident = .//conditionvar/varequal)]')
    [ "$bad" = 0 ] || echo "not ok $name: $bad right answers are no option"
done
check "and all questions" [ "$items" = $((questions + exercises)) ]
grep -h '{\.[a-z]\|:::\|@NAME\|@[a-z]*:\|\[x\]' "$moodle" "$place"/canvas/e*.xml >"$said"
check "nothing is left of our markup" [ ! -s "$said" ]
same "students are not shown how an essay is marked" 0 "$moodle" \
    '/quiz/question[@type="essay"][generalfeedback/text/text()]'

same "who marks an essay is told how, in QTI" 0 "$place/canvas/exam-ch04.xml" \
    '//item[.//fieldentry="essay_question"][not(rubric[@view="Scorer"]//mattext/text())]'
same "and nobody else" 0 "$place/canvas/exam-ch04.xml" \
    '//item[.//fieldentry="essay_question"][itemfeedback//mattext/text()]'

# ---- one chapter ---------------------------------------------------------
chapter=$BUILD/export/chapters
check "each file can be had alone" [ "$(ls "$chapter" | wc -l)" -eq $((4 * chapters)) ]
mkdir "$place/one"
(cd "$place/one" && unzip -q "$chapter/canvas-exam-ch04.zip") >"$said" 2>&1
check "Canvas's is one file and its manifest" [ "$(ls "$place/one" | tr '\n' ' ')" = \
    "exam-ch04.xml imsmanifest.xml " ]
same "which names it alone" 1 "$place/one/imsmanifest.xml" '//resource[file/@href="exam-ch04.xml"]'
same "and nothing else" 1 "$place/one/imsmanifest.xml" '//resource'
same "Moodle's has the chapter's questions" "$(grep -c '^## ' book/manual/exam/ch04.md)" \
    "$chapter/moodle-exam-ch04.xml" '/quiz/question[@type!="category"]'

# A bank may draw any question alone.
for file in book/manual/exam/ch*.md; do
    awk '/^## / { getline; getline
        if (/^(The|On the|In the|With the|Of the|For the) same |^(Now|And|Then|Here|There|These|Those|This|It|They) / || /question (above|before)/)
            print FILENAME ": " $0 }' "$file"
done >"$said"
check "each question stands alone" [ ! -s "$said" ]

for file in book/manual/exam/ch*.md; do
    [ "$(grep -c '^## ' "$file")" -ge 5 ] ||
        echo "not ok $file has fewer than five questions"
done

# ---- questions with faults ---------------------------------------------
mkdir "$place/book"
cp -R "$root/tests/press/good/." "$place/book"
mkdir -p "$place/book/book/manual/exam" "$place/book/build"
cat >"$place/book/book/manual/exam/ch01.md" <<'END'
## Two are right {.choice points=2}

Which?

- [x] this
- [x] that
- [ ] none

::: answer
Both.
:::

## No number {.number points=2}

How many?

::: answer
Many.
:::

## No kind {points=2}

Why?

## No points {.essay}

Why?

::: answer
So.
:::
END
mkdir -p "$place/out/canvas" "$place/out/chapters"
texlua book/press/press.lua --export "$place/out" --root "$place/book" >"$said" 2>&1
while IFS= read -r words; do
    check "told: $words" grep -q -F "$words" "$said"
done <<'END'
ch01.md:1: of 3 options 2 are right
ch01.md:13: a question needs answer=
ch01.md:21: a question is a choice, a number or an essay
ch01.md:21: this question has no text, no options or no answer
ch01.md:25: a question needs points=
END
