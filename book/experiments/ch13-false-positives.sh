#!/bin/sh
# False positives, candidates without an event, over the length of a step
exec "$BUILD/ch13/false_positives" ${FULL:+100000}
