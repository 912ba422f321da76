#!/bin/sh
# A release, packed in a copy of the project from PDFs that are no more
# than files: what both editions hold, that they are complete, that they
# are refused when there is a reason, and that the numbers of the version
# agree. `make check-release` builds and tests what is packed.
root=$(cd "$(dirname "$0")/../.." && pwd)
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
trap 'exit 1' HUP INT TERM
unset MAKEFLAGS MFLAGS MAKELEVEL
said=$place/said
copy=$place/copy
mkdir "$place/bin"
cd "$root" || exit 1
. tests/checks
copy_project "$copy"
cd "$copy" || exit 1
BUILD=build
export BUILD
version=$(sed -n 's/^## *\([^ ,]*\).*/\1/p' CHANGES.md | head -n 1)

# A PDF is text here.
printf '#!/bin/sh\ncat "$2"\n' >"$place/bin/pdftotext"
chmod +x "$place/bin/pdftotext"
release() {
    PATH=$place/bin:$PATH VERSION=$1 exercises/course/release $2 >"$said" 2>&1
}

# refused NAME WORDS VERSION: status 2, and nothing is left.
refused() {
    release "$3"
    status=$?
    check "$1" left_nothing "$2"
}
left_nothing() {
    says "$1" && [ $status -eq 2 ] && [ ! -e build/release ]
}

refused "no version" "make release VERSION=2.0" ""
refused "a version without its changes" "CHANGES.md begins with" 77.1
refused "a release before there is a book" "there is no build/near-and-far.pdf" "$version"
mkdir -p build/slides build/export build/pictures/drawings build/web
for file in near-and-far.pdf solutions.pdf slides/ch04.pdf export/moodle.xml \
    pictures/drawings/ch04-scan.svg web/index.html web/index.js; do
    echo "Count, scan, place" >"build/$file"
done
cp CITATION.cff "$place"
sed -i.bak 's/^version:.*/version: "0.9"/' CITATION.cff
refused "another version in the citation" "CITATION.cff says version 0.9" "$version"
cp "$place/CITATION.cff" .

solution=exercises/ch04/2-how-many-between/solution.c
cp $solution book/press/helpful.txt
refused "a solution beside the press" "book/press/helpful.txt" "$version"
rm book/press/helpful.txt
sed -n '/^::: answer/,/^:::$/p' exercises/ch04/1-nine-numbers/exercise.md \
    >>build/near-and-far.pdf
refused "an answer in the book" "near-and-far.pdf" "$version"
echo "Count, scan, place" >build/near-and-far.pdf

# ---- what is packed --------------------------------------------------
release "$version"
check "a release" [ $? -eq 0 ]
edition=near-and-far-$version
check "all of it" [ "$(ls -A build/release | tr '\n' ' ')" = \
    "CHANGES.md SHA256SUMS $edition-instructor.tar.gz $edition-pictures.zip $edition-web.zip $edition.pdf $edition.tar.gz " ]
(cd build/release && sha256sum -c SHA256SUMS) >"$said" 2>&1
check "its sums are right" [ $? -eq 0 ]
check "and are six" [ "$(wc -l <"$said" | tr -d ' ')" = 6 ]
mkdir "$place/student" "$place/instructor"
(cd "$place/student" && tar xzf "$copy/build/release/$edition.tar.gz")
(cd "$place/instructor" && tar xzf "$copy/build/release/$edition-instructor.tar.gz")

cd "$place/student/$edition" || exit 1
find . -path ./tests/press -prune -o -print >"$said"
check "no solution for students, no mutant, no course" \
    lacks 'solution\.c\|mutants\|/course$\|/course/\|book/manual\|solutions\.pdf'
check "but starters" says "4-back-in-order/starter.c"
check "and the book" [ -s near-and-far.pdf ]
check "and the slides" says "chapters/slides/ch04.md"
grep -r '^::: *{*\.*\(answer\|reasoning\|marking\|rubric\)' exercises book >"$said"
check "no answers, no rubrics" [ ! -s "$said" ]
make help >"$said" 2>&1
check "its Makefile works" says "(the default)"
check "and offers what it has" lacks 'sheet\|handout\|release\|nothing makes'
make -n programs slides4 exercise4.4 BUILD="$place/none" >"$said" 2>&1
check "programs, slides and exercises can be made" lacks 'No rule\|nothing makes'
texlua book/press/press.lua --check --slides chapters/slides/ch04.md \
    --build "$place/none" >"$said" 2>&1
check "its press runs" grep -q "there is no figure\|^press: [0-9]* fault" "$said"
check "its README speaks to students" [ "$(grep -c 'instructor' README.md)" = 0 ]
head -n 12 "$copy/README.md" >"$said"
check "README's first lines name both editions" \
    says "$edition.tar.gz"
check "and the instructor's" says "$edition-instructor.tar.gz"

cd "$place/instructor/$edition-instructor" || exit 1
find . >"$said"
for part in near-and-far.pdf solutions.pdf slides/ch04.pdf export/moodle.xml \
    exercises/ch04/2-how-many-between/solution.c book/manual/2-course.md \
    exercises/course/release tests/release/release.sh CITATION.cff; do
    check "instructors get $part" says "./$part"
done
check "nothing that was built" lacks '^./build\|^./work'

# ---- the citation ------------------------------------------------------
# pandoc reads YAML: what the Citation File Format, version 1.2.0, wants.
cd "$root" || exit 1
cat >"$place/cff.lua" <<'END'
function Meta(meta)
  local say = pandoc.utils.stringify
  local function want(holds, what) if not holds then io.stderr:write(what, "\n") end end
  for _, key in ipairs { "cff-version", "message", "title", "authors" } do
    want(meta[key], "no " .. key)
  end
  want(say(meta["cff-version"]) == "1.2.0", "another version of the format")
  want(#meta.authors > 0 and meta.authors[1].name, "no author's name")
  want(say(meta["date-released"]):match("^%d%d%d%d%-%d%d%-%d%d$"), "no date")
  want(say(meta.type) == "software", "no type that is known")
end
END
{ echo ---; cat CITATION.cff; echo ---; } |
    pandoc -f markdown -t plain --lua-filter="$place/cff.lua" 2>"$said" >/dev/null
check "CITATION.cff is valid" [ ! -s "$said" ]
