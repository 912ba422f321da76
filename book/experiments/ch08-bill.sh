#!/bin/sh
# The bill of the march, loop by loop, nanoseconds a point
# demo: table
exec "$BUILD/ch08/bill" ${FULL:+100000 25}
