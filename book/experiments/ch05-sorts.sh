#!/bin/sh
# The cell sort by threads, nanoseconds a point
# demo: table
if [ -n "$FULL" ]; then
    exec "$BUILD/ch05/sorts" 10000000 7 uniform memory
fi
exec "$BUILD/ch05/sorts" 1000000 3 uniform memory
