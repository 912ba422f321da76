#!/bin/sh
# The mean distances of 100,000 points
# demo: table
exec "$BUILD/ch10/means" means ${FULL:+100000 10}
