#!/bin/sh
# Every step of a search by cells, nanoseconds a point
# demo: table
exec "$BUILD/ch05/build" ${FULL:+4000000 7}
