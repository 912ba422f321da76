# It begins at the front, over values that have not moved yet.
# expect: overwritten before they have moved
# why: It is the loop of pack with the two sides exchanged.
s/i = n; i-- > 0;/i = left = 0; i < n; i++/
s/--left/left++/
