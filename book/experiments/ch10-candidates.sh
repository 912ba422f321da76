#!/bin/sh
# Candidates of the corner trick and along the border
# demo: table
exec "$BUILD/ch10/candidates" ${FULL:+100000}
