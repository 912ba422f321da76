# It forgets that an odd number of passes ends in the other array.
# expect: The sorted records are in array 1
# why: With four passes the result is in array 0, and all their keys had four bytes.
s/return from;/return 0;/
