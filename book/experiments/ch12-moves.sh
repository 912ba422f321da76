#!/bin/sh
# References that move with their points
exec "$BUILD/ch12/moves" ${FULL:+300000}
