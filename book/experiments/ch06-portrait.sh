#!/bin/sh
# The escape times of a picture
exec "$BUILD/ch06/portrait"
