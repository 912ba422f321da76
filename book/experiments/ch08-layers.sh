#!/bin/sh
# Tasks and cells in every layer of the search in step, counted and expected
exec "$BUILD/ch08/layers" 
