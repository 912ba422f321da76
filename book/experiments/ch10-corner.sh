#!/bin/sh
# Two searches by the corner trick, cell by cell
exec "$BUILD/ch10/corner"
