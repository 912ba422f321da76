#!/bin/sh
# Mean distances in both geometries, over several sets of points
exec "$BUILD/ch02/distances" means ${FULL:+100000 10}
