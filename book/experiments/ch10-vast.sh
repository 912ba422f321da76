#!/bin/sh
# The mean distances of ten million points
exec "$BUILD/ch10/means" means ${FULL:+10000000 3}
