# book/manual/1-plan.md
# expect: book/manual/1-plan.md:7: a week needs read, sheet and exercises
# solutions
7s/sheet="One"//
