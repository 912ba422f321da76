#!/bin/sh
# All pairs and half the pairs, nanoseconds a pair
# demo: table
exec "$BUILD/ch03/speed" ${FULL:+12000 11}
