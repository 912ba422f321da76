# It shares the points among the threads that it asked for.
# expect: threads that did not come
# why: On an idle machine with a small wish, all who are asked come.
s/all = omp_get_num_threads()/all = threads/
