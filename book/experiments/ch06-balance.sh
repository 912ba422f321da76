#!/bin/sh
# Packing often and seldom, nanoseconds a useful step
# demo: table
exec "$BUILD/ch06/balance" ${FULL:+15}
