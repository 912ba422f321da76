# Counts every step twice.
# expect: there is room for more
# why: The two steps to the left are subtracted from the room as well.
s/room -= sum;/room -= room < 2 * sum ? room : 2 * sum;/
