#!/bin/sh
# The pages in a browser.
BUILD=${BUILD:-build}
exec node "$(dirname "$0")/browser.mjs" "$BUILD"
