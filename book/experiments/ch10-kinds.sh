#!/bin/sh
# The furthest of points of every kind
# demo: table
exec "$BUILD/ch10/kinds" ${FULL:+20000 5}
