#!/bin/sh
# The corners of the hull, counted and expected
# demo: table
exec "$BUILD/ch10/corners" ${FULL:+10000000 100}
