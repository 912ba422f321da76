#!/bin/sh
# A walk through memory in random order: ns a step
exec "$BUILD/ch02/chase" ${FULL:+65536 1000000 7}
