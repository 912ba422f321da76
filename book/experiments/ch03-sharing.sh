#!/bin/sh
# Two counters on one cache line and on two, nanoseconds a step
# demo: table
exec "$BUILD/ch03/false-sharing" ${FULL:+10000000 11}
