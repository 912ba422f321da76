# Counts the zeros with a scan of their own.
# expect: One scan will do
s/subtract(numbers(n), ones.before)/scan(subtract(constant(n, 1), flags)).before/
