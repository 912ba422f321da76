#!/bin/sh
# Cells, distances and wrong neighbors for each point, expected and counted
# demo: table
exec "$BUILD/ch04/counts" ${FULL:+1000000 4}
