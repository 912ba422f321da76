#!/bin/sh
# One search, cell by cell
exec "$BUILD/ch07/trace"
