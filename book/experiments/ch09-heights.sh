#!/bin/sh
# The whole time a point, from a thousand points to ten million
exec "$BUILD/ch09/heights" ${FULL:+10000000}
