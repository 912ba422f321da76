#!/bin/sh
# Nearest, furthest and both over the number of points
# demo: table
exec "$BUILD/ch10/sizes" ${FULL:+10000000}
