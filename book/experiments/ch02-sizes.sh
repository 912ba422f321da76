#!/bin/sh
# More and more points: ns a pair
exec "$BUILD/ch02/sizes" ${FULL:+262144 6e7 15}
