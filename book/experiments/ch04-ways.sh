#!/bin/sh
# Three ways to hold the cells, built and searched, nanoseconds a point
# demo: table
exec "$BUILD/ch04/ways" ${FULL:+1000000 5}
