#!/bin/sh
# Nine points and a box: what each structure looks at
# demo: table
exec "$BUILD/ch12/nine"
