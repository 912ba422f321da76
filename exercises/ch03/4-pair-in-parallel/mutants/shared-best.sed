# All threads update one best pair.
# expect: An update was lost
s/struct pair mine = .*//
/#pragma omp critical/,/best = mine;/d
s/better(pair, mine)/better(pair, best)/
s/mine = pair/best = pair/
