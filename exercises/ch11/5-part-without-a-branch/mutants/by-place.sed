# Compares the value at the place, and not that of the number.
# expect: in their order
# why: The list is a list of numbers, and k is one, too.
s/value\[number\] < cut/value[k] < cut/
