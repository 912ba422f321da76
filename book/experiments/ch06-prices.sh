#!/bin/sh
# The primitives cache by cache, nanoseconds an element
# demo: table
exec "$BUILD/ch06/prices" ${FULL:+31 134217728}
