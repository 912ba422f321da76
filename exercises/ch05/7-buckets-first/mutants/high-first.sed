# The upper half first, then the lower one.
# expect: The round that decides must come last
# why: One sorts by the important part first, as in a dictionary.
s/% BUCKETS/@ BUCKETS/g; s/\/ BUCKETS/% BUCKETS/g; s/@ BUCKETS/\/ BUCKETS/g
