# Nothing is given up.
# expect: Is memory used again
# why: back_to was left for the end, and all the first tests pass without it.
s/top = height;/(void)height;/
