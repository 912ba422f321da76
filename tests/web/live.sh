#!/bin/sh
# The figures that run, in a browser.
BUILD=${BUILD:-build}
exec node "$(dirname "$0")/live.mjs" "$BUILD"
