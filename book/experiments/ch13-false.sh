#!/bin/sh
# Candidates without an event, over the length of a step
exec "$BUILD/ch13/false_share" ${FULL:+100000}
