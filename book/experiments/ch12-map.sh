#!/bin/sh
# Which structure is the fastest, and where
# demo: table
exec "$BUILD/ch12/map" ${FULL:+1000000 9}
