#!/bin/sh
# Blocks of candidates, small and large: ns a pair
exec "$BUILD/ch02/block-size" ${FULL:+20000 4000 31}
