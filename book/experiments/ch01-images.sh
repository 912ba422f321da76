#!/bin/sh
# Distances from one point, in both geometries
exec "$BUILD/ch01/images"
