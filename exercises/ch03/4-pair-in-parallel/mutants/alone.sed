# The number of threads is not asked for.
# expect: one thread did all the work
# why: OMP_NUM_THREADS is set in their shell, and the parameter is never used.
s/ num_threads(threads)//
