#!/bin/sh
# Times of boxes in one to eight dimensions
exec "$BUILD/ch12/dimensions" ${FULL:+300000 15}
