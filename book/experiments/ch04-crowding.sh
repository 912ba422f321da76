#!/bin/sh
# Distances a point, for cells of two points and cells that grow
exec "$BUILD/ch04/crowding" ${FULL:+409600}
