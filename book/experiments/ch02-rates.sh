#!/bin/sh
# What the vector units can do: ns an operation
exec "$BUILD/ch02/rates" ${FULL:+501}
