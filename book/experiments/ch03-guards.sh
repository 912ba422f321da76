#!/bin/sh
# The triangular loop under each guard, nanoseconds an ordered pair
# demo: table
exec "$BUILD/ch03/guards" ${FULL:+2000 11}
