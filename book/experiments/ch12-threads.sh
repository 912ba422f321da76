#!/bin/sh
# The k-d tree built by more threads
exec "$BUILD/ch12/threads" ${FULL:+1000000 15}
