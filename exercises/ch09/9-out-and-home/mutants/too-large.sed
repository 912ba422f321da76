# Makes buckets that the cache does not hold.
# expect: Make them smaller
# why: Few buckets seem better, since fewer lines are open.
s/BUCKET = 768/BUCKET = 8192/
