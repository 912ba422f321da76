# Who does not sum goes on, with counts that are not summed yet.
# expect: everybody waits until all counts are summed
s/#pragma omp single/& nowait/
