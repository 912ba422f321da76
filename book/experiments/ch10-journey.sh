#!/bin/sh
# The whole journey: every program of the book, nanoseconds a point
# demo: table
exec "$BUILD/ch10/journey" ${FULL:+100000 20000 25}
