# It shares the points among the threads that it asked for.
# expect: threads that did not come
s/all = omp_get_num_threads()/all = threads/
