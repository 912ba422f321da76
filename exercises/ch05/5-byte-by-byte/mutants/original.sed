# Every pass reads array 0 and writes array 1.
# expect: read what the pass before it wrote
s/from = 1 - from;//
s/return from;/return 1;/
