#!/bin/sh
# The primitives length by length, nanoseconds an element
exec "$BUILD/ch06/lengths" ${FULL:+3 134217728}
