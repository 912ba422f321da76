#!/bin/sh
# The same sweep, timed again and again
exec "$BUILD/ch01/trials" 1000
