#!/bin/sh
# Sizes of leaves and cells
exec "$BUILD/ch12/tuning" ${FULL:+1000000 15}
