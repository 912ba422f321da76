#!/bin/sh
# A gather instruction beside a loop, nanoseconds an element
exec "$BUILD/ch06/gathers" ${FULL:+51}
