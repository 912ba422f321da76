#!/bin/sh
# The same on crowded points
set -- uniform clustered two-clusters kuzmin equal
if [ -n "$FULL" ]; then
    exec "$BUILD/ch05/sorts" 4000000 7 "$@"
fi
exec "$BUILD/ch05/sorts" 500000 3 "$@"
