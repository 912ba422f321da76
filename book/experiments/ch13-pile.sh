#!/bin/sh
# A pile over its steps
exec "$BUILD/ch13/pile" ${FULL:+1000 2000 40}
