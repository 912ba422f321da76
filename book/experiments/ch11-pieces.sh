#!/bin/sh
# What pieces points of every kind are cut into
# demo: table
exec "$BUILD/ch11/pieces" ${FULL:+1000000}
