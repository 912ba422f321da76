#!/bin/sh
# Five rules for where phase two looks, and their wrong answers
# demo: table
exec "$BUILD/ch07/rules" ${FULL:+1000000}
