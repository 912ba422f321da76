#!/bin/sh
# Answers that come out wrong when nothing is guarded
# demo: table
exec "$BUILD/ch03/lost-updates" ${FULL:+200 4000}
