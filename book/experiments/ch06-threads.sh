#!/bin/sh
# Scan and pack over threads, nanoseconds an element
exec "$BUILD/ch06/threads" ${FULL:+31 16777216}
