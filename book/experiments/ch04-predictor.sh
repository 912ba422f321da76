#!/bin/sh
# Branches that a predictor gets wrong, for each query, by the length of its history
exec "$BUILD/ch04/predictor" ${FULL:+320}
