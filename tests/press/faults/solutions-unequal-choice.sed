# book/manual/1-plan.md
# expect: book/manual/1-plan.md:7: who chooses 1.2 has more or less to do
# solutions
7s/exercises=/choose="one" exercises=/
