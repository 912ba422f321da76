#!/bin/sh
# More and more threads: ns in all
# demo: table
exec "$BUILD/ch02/threads" ${FULL:+20000 11}
