# Who does not sum goes on, with counts that are not summed yet.
# expect: all counts
# why: "nowait" makes programs faster.
s/#pragma omp single/& nowait/
s/point\[r++\]/point[r++ % n]/
