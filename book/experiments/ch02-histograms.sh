#!/bin/sh
# Histograms of the distances in both geometries
exec "$BUILD/ch02/distances" histogram ${FULL:+100000 1}
