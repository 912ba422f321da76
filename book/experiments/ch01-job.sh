#!/bin/sh
# A job part by part: reading, answering, writing
# demo: table
export OMP_WAIT_POLICY=passive GOMP_SPINCOUNT=1000 # as near has it
"$BUILD/ch01/job" ${FULL:+1000000 15} || exit 1
plain=$("$BUILD/ch01/job-plain" ${FULL:+1000000 5}) || exit 1
echo "$plain" | grep '^plain'
