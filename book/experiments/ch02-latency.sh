#!/bin/sh
# The latencies of the operations in a pair's chains: cycles
exec "$BUILD/ch02/latency" ${FULL:+501}
