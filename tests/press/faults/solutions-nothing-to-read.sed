# book/manual/1-plan.md
# expect: book/manual/1-plan.md:7: the book has nothing to read that is "sec:love"
# solutions
7s/ch:ch01/sec:love/
