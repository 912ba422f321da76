# The loop is not shared: every thread runs all of it.
# expect: every thread runs the whole loop
# why: They write a parallel region and forget that it takes a "for" inside it to share a loop.
s/#pragma omp for.*//
