#!/bin/sh
# Histograms of the furthest distances
exec "$BUILD/ch10/means" histogram ${FULL:+100000 1}
