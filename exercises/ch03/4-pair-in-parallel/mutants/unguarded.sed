# The threads hand in their results without waiting for each other.
# expect: An update was lost
/#pragma omp critical/d
