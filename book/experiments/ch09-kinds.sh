#!/bin/sh
# Row spans on points of every kind
exec "$BUILD/ch09/kinds" ${FULL:+20000 1000000 3}
