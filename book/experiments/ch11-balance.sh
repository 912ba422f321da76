#!/bin/sh
# How even the work of the leaves is, and how threads share it
exec "$BUILD/ch11/balance" ${FULL:+1000000}
