#!/bin/sh
# A step with its arrays in pages at random
# demo: table
exec "$BUILD/ch06/aliases" ${FULL:+1000}
