#!/bin/sh
# The geometry by pointer, by flag and by copy: ns a pair
exec "$BUILD/ch02/dispatch" ${FULL:+20000 1600 15}
