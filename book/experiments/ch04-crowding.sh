#!/bin/sh
# Distances and nanoseconds a point, for cells of two points and cells that grow
exec "$BUILD/ch04/crowding" ${FULL:+409600}
