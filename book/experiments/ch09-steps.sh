#!/bin/sh
# The search of chapter 9, step by step
# demo: table
exec "$BUILD/ch09/steps" ${FULL:+1000000 5}
