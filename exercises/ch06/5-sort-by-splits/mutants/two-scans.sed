# Counts the zeros with a scan of their own.
# expect: One scan will do
# why: It is right, obvious, and two cycles dearer.
s/subtract(numbers(n), ones.before)/scan(subtract(constant(n, 1), flags)).before/
