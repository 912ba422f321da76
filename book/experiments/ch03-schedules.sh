#!/bin/sh
# Schedules and chunks, nanoseconds an ordered pair
exec "$BUILD/ch03/schedules" ${FULL:+8000 11}
