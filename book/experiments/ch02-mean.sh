#!/bin/sh
# A running mean against a sum: ns a point, relative error
exec "$BUILD/ch02/mean" ${FULL:+100000 501}
