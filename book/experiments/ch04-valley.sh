#!/bin/sh
# How many points a cell should hold: sorting and searching, nanoseconds a point
exec "$BUILD/ch04/valley" ${FULL:+100000 7}
