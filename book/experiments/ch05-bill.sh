#!/bin/sh
# What a point and a loser cost, nanoseconds a point
exec "$BUILD/ch05/bill" ${FULL:+1000000 15}
