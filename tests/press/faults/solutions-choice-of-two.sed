# book/manual/1-plan.md
# expect: book/manual/1-plan.md:7: only one can be chosen
# solutions
7s/exercises=/choose="two" exercises=/
