#!/bin/sh
# How often each cell around a point is looked at
exec "$BUILD/ch07/visits" ${FULL:+1000000}
