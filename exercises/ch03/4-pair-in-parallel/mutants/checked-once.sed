# The check stands outside, only the update is in the critical region.
# expect: An update was lost
/#pragma omp critical/d
s/^            best = mine;/{\
_Pragma("omp critical") best = mine;\
}/
