# Makes a bucket too few.
# expect: bucket
# why: The division rounds down, and a part of a bucket is left.
s/BUCKETS = RECORDS_MOST \/ BUCKET + 1/BUCKETS = 60/
s/b < BUCKETS; b++)$/b < BUCKETS - 2; b++)/
