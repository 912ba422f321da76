# The loop is not shared: every thread runs all of it.
# expect: every thread runs the whole loop
s/#pragma omp for.*//
