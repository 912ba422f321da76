#!/bin/sh
# What the lanes of a vector do, with and without packing
exec "$BUILD/ch06/lanes"
