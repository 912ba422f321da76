#!/bin/sh
# Wrong answers of the two tricks
# demo: table
exec "$BUILD/ch10/wrong" ${FULL:+100000 400}
