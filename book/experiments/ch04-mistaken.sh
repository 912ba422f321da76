#!/bin/sh
# A wrong neighbor, found by searching nine cells
exec "$BUILD/ch04/mistaken"
