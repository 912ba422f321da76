#!/bin/sh
# `make peers` asks ./setup for what it needs, which says what is missing.
found=$(CXX=/nonexistent ./setup --list peers 2>&1)
status=$?
case "$status $found" in
"1 setup: not found:"*" c++ nanoflann cgal ann flann tbb lz4 bullet" | \
    "1 setup: not found:"*" c++ nanoflann cgal ann flann tbb lz4 bullet scipy") ok=yes ;;
*) ok= ;;
esac
[ $ok ] && echo "ok without a C++ compiler nothing is found" ||
    echo "not ok without a C++ compiler nothing is found: status $status, \"$found\""
