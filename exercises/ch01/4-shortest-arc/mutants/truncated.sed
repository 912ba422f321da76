# The comparison returns a difference, and int makes 0 of it.
# expect: int
s/return (x > y) - (x < y);/return x - y;/
