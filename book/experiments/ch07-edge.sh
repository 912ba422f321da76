#!/bin/sh
# Distances a point with an edge and without, over many sets of points
exec "$BUILD/ch07/edge" ${FULL:+1000 1000}
