# The seed is not used.
# expect: seed
# why: A constant seed was convenient while they tried things out, and stayed.
s/{seed}/{42}/
