# The first thread to arrive sums, though others still count.
# expect: it takes a barrier
# why: There is a "single" with an implied barrier, at its end; they wanted one at its beginning.
/#pragma omp barrier/d
