# It forgets that an odd number of passes ends in the other array.
# expect: The sorted records are in array 1
s/return from;/return 0;/
