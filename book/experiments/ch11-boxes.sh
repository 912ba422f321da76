#!/bin/sh
# The pieces of the disc of Kuzmin, for a picture
exec "$BUILD/ch11/boxes"
