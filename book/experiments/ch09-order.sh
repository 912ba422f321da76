#!/bin/sh
# Batches of four and of eight, on points in any order and in the order of the cells
# demo: table
exec "$BUILD/ch09/order" ${FULL:+1000000 20000 11}
