#!/bin/sh
# Pairs of points whose distance depends on rounding
# demo: table
exec "$BUILD/ch01/rounding" ${FULL:+4000}
