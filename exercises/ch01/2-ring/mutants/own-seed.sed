# The seed is not used.
# expect: seed
s/{seed}/{42}/
