#!/bin/sh
# The worst of boxes, in the k-d tree
exec "$BUILD/ch12/lines" ${FULL:+1000000}
