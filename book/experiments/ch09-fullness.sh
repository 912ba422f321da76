#!/bin/sh
# Row spans over the points in a cell, counted, expected and timed
exec "$BUILD/ch09/fullness" ${FULL:+1000000 3}
