#!/bin/sh
# The same instructions with and without surprises: ns a pair
exec "$BUILD/ch02/surprises" ${FULL:+20000 1000 15}
