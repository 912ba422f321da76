# Makes more buckets than the cache has lines.
# expect: Make them larger
# why: Small buckets seem better, since each fits into the cache many times.
s/BUCKET = 768/BUCKET = 64/
