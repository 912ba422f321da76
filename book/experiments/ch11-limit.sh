#!/bin/sh
# The same points in one grid and in pieces, ever denser
# demo: table
exec "$BUILD/ch11/limit" ${FULL:+1000000 15}
