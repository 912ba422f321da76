# Whoever comes first sums, though others still count.
# expect: it takes a barrier
/#pragma omp barrier/d
