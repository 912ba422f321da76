#!/bin/sh
# Points, cells and the order of the cell sort
exec "$BUILD/ch04/portrait"
