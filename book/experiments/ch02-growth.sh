#!/bin/sh
# The mean nearest distance as points are added
exec "$BUILD/ch02/growth" ${FULL:+51200}
