#!/bin/sh
# Close points, and how deep an orthotree becomes
exec "$BUILD/ch12/depth"
