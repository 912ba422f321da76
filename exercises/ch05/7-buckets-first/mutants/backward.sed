# The second round reads from the end.
# expect: keep the order
# why: The loop that counts down is remembered from another sort.
s/point\[high\[records\[r\].cell \/ BUCKETS\]++\] = records\[r\].point/point[high[records[n - 1 - r].cell \/ BUCKETS]++] = records[n - 1 - r].point/
