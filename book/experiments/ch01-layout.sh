#!/bin/sh
# A query against every point, by the layout of the points
# demo: table
exec "$BUILD/ch01/layout" ${FULL:+100000 1001}
