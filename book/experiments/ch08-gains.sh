#!/bin/sh
# Every version of the spiral search with its sort, nanoseconds a point
# demo: table
exec "$BUILD/ch08/gains" ${FULL:+100000 15}
