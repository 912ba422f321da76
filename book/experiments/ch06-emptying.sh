#!/bin/sh
# The points that are still on their way, in percent
exec "$BUILD/ch06/emptying" ${FULL:+1920 2048}
