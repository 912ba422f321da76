# The number of threads is not asked for.
# expect: one thread did all the work
# why: The parameter looks like information, not like an order.
s/ num_threads(threads)//
