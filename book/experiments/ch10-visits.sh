#!/bin/sh
# Cells and distances of the search from outside
# demo: table
exec "$BUILD/ch10/visits" ${FULL:+100000 100}
