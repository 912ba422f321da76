#!/bin/sh
# What a search for neighbors looks at
exec "$BUILD/ch12/neighbors" ${FULL:+1000000}
