#!/bin/sh
# From the first version to the last: ns a pair on one core
# demo: table
exec "$BUILD/ch02/climb" ${FULL:+20000 2000 15}
