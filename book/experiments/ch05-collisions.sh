#!/bin/sh
# Collisions in groups of lanes, expected and counted
exec "$BUILD/ch05/birthdays" ${FULL:+131072 40}
