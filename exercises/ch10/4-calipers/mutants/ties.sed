# Takes the first pair that it meets.
# expect: These tie
# why: In a loop over the lower number, the first would be the lowest.
s/pair.d2 == best->d2 \&\&/0 \&\&/
