#!/bin/sh
# Broad phases over the number of triangles
# demo: table
exec "$BUILD/ch13/broad_phases" ${FULL:+100000 5}
