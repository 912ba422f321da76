# The comparison returns a difference, and int makes 0 of it.
# expect: int
# why: For integers the difference is an idiom, and the compiler converts the double without a word.
s/return (x > y) - (x < y);/return x - y;/
