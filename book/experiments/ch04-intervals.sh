#!/bin/sh
# Three ways to search a line: nanoseconds a number to build, and for a query
# demo: table
exec "$BUILD/ch04/intervals" ${FULL:+1000000 5}
