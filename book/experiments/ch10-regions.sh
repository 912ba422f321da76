#!/bin/sh
# Who is furthest from whom
exec "$BUILD/ch10/fans" 4000
