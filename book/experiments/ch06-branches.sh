#!/bin/sh
# Pack, with and without branches, nanoseconds an element
exec "$BUILD/ch06/branches" ${FULL:+131072 21}
