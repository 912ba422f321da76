#!/bin/sh
# Times of searches by pieces, on points of every kind
# demo: table
exec "$BUILD/ch11/kinds" ${FULL:+1000000 7}
