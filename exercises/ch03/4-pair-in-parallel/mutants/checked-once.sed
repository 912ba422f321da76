# The check stands outside, only the update is in the critical region.
# expect: An update was lost
# why: They want to keep the critical region short, and take the comparison for harmless because it only reads.
# points: 3
/#pragma omp critical/d
s/^            best = mine;/{\
_Pragma("omp critical") best = mine;\
}/
