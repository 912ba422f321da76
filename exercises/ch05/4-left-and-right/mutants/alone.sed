# The number of threads is not asked for.
# expect: num_threads(threads)
# why: The parameter looks like information, not like an order.
s/ num_threads(threads)//
