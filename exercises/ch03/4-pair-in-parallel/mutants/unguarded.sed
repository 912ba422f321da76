# The threads hand in their results without waiting for each other.
# expect: An update was lost
# why: Handing in takes a few nanoseconds of seconds, so nothing ever seems to happen.
# points: 3
/#pragma omp critical/d
