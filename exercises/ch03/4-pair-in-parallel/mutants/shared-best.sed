# All threads update one best pair.
# expect: An update was lost
# why: The program is the serial one with a pragma in front, and with two threads it is right nearly always.
# points: 3
s/struct pair mine = .*//
/#pragma omp critical/,/best = mine;/d
s/better(pair, mine)/better(pair, best)/
s/mine = pair/best = pair/
