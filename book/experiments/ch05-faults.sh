#!/bin/sh
# Page faults of a sort: pages that the system finds and clears for it
exec "$BUILD/ch05/faults" ${FULL:+10000000}
