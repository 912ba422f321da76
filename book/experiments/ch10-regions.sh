#!/bin/sh
# Who is furthest from whom
exec "$BUILD/ch10/regions" 4000
