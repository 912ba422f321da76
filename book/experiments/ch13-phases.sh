#!/bin/sh
# What the phases of a step take
exec "$BUILD/ch13/phases" ${FULL:+100000 9}
