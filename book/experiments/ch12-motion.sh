#!/bin/sh
# Points that move: update, and the queries after
exec "$BUILD/ch12/motion" ${FULL:+300000 15}
