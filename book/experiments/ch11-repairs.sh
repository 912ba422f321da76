#!/bin/sh
# Repairs of the grid that do not last
# demo: table
exec "$BUILD/ch11/repairs" ${FULL:+100000}
