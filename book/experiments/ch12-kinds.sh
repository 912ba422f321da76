#!/bin/sh
# What the structures cost, on points of several kinds
# demo: table
exec "$BUILD/ch12/kinds" ${FULL:+300000 7}
