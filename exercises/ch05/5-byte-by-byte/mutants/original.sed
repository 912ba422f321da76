# Every pass reads array 0 and writes array 1.
# expect: read what the pass before it wrote
# why: The first pass is tested, and the others are copies of it.
s/from = 1 - from;//
s/return from;/return 1;/
