#!/bin/sh
# The exercises themselves: texts, starters, solutions and mutants.
exec exercises/kit/check
