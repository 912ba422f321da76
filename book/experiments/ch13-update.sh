#!/bin/sh
# Build anew or update, over the length of a step
exec "$BUILD/ch13/update" ${FULL:+30000 7}
