#!/bin/sh
# Each thread's share of the triangle under static schedules
exec "$BUILD/ch03/load"
