#!/bin/sh
# Where the time of row spans goes, beside the floor
# demo: table
exec "$BUILD/ch09/phases" ${FULL:+10000000 3}
