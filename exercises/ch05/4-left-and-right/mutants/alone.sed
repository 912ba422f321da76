# The number of threads is not asked for.
# expect: num_threads(threads)
s/ num_threads(threads)//
