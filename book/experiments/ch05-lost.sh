#!/bin/sh
# Points that vanish when colliding lanes and threads count without care
exec "$BUILD/ch05/lost-counts" ${FULL:+4194304}
