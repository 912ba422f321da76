#!/bin/sh
# Points from every generator
exec "$BUILD/ch01/portraits" 500
