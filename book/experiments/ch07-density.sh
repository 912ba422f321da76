#!/bin/sh
# Spiral search over the points in a cell, counted, expected and timed
# demo: table
exec "$BUILD/ch07/density" ${FULL:+1000000 3}
