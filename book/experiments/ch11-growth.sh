#!/bin/sh
# Distances a point of every kind, and how they grow
exec "$BUILD/ch11/growth" ${FULL:+1000000 10000}
