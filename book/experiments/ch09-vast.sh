#!/bin/sh
# A hundred million points
exec "$BUILD/ch09/vast" ${FULL:+100000000}
