#!/bin/sh
# All pairs and half the pairs, nanoseconds an ordered pair
# demo: table
exec "$BUILD/ch03/speed" ${FULL:+12000 11}
