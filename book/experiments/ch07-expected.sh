#!/bin/sh
# What a spiral search should cost, computed
exec "$BUILD/ch07/expect"
