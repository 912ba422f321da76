#!/bin/sh
# Spiral searches one by one and in step, from a thousand points to three million
exec "$BUILD/ch08/sizes" ${FULL:+3000000 5}
