#!/bin/sh
# Schedules and chunks, nanoseconds a pair
exec "$BUILD/ch03/schedules" ${FULL:+8000 11}
