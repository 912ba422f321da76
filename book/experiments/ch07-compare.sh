#!/bin/sh
# Spirals beside blocks, on points of several kinds
# demo: table
exec "$BUILD/ch07/compare" ${FULL:+20000 5}
