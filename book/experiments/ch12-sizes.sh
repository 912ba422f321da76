#!/bin/sh
# Times of boxes of all sizes, every structure
exec "$BUILD/ch12/sizes" ${FULL:+1000000 15}
