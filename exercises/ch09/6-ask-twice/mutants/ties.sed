# Takes the first of those that tie.
# expect: These tie
s/(d2 == found.nearest2 \&\&/(0 \&\&/
