#!/bin/sh
# Wrong guesses for an element, of simple branch predictors
exec "$BUILD/ch06/predictors"
