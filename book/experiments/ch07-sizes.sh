#!/bin/sh
# Distances and time a point from a thousand points to ten million
exec "$BUILD/ch07/sizes" ${FULL:+10000000 5}
