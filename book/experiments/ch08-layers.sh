#!/bin/sh
# Tasks and cells in every layer of the march, counted and expected
exec "$BUILD/ch08/layers" 
