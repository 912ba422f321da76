#!/bin/sh
# The bill of the search in step, loop by loop, nanoseconds a point
# demo: table
exec "$BUILD/ch08/bill" ${FULL:+100000 25}
