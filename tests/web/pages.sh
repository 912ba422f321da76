#!/bin/sh
# The pages as files: links, numbers as in print, valid HTML.
BUILD=${BUILD:-build}
here=$(dirname "$0")
texlua "$here/links.lua" "$BUILD/web"

texlua "$here/../../book/press/press.lua" --check --build "$BUILD" >"$BUILD/web-check/press.log" 2>&1 ||
    echo "not ok numbers: the press stopped, see $BUILD/web-check/press.log"
texlua "$here/numbers.lua" "$BUILD/book/book.tex" "$BUILD/web"

# The validator does not know all that the parser of MathML may hold.
java -jar "$BUILD"/web-check/node_modules/vnu-jar/build/dist/vnu.jar --errors-only \
    --skip-non-html --format gnu "$BUILD/web" >"$BUILD/web-check/html.log" 2>&1
if [ -s "$BUILD/web-check/html.log" ]; then
    sed 's/^/not ok html: /' "$BUILD/web-check/html.log" | head -n 20
else
    echo "ok html"
fi
