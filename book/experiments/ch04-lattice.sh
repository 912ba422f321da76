#!/bin/sh
# The same counts on uniform points and on a lattice, nanoseconds a point
# demo: table
exec "$BUILD/ch04/lattice" ${FULL:+320 11}
