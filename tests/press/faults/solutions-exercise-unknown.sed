# book/manual/1-plan.md
# expect: book/manual/1-plan.md:7: there is no exercise 1.3
# solutions
7s/1\.2/1.3/
