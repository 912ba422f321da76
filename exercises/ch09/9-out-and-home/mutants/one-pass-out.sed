# Leaves the buckets as they are.
# expect: Is each bucket sorted by cell
# why: They forget the second pass, which is the one that sorts.
s/set(SORTED, next\[record.cell % BUCKET\]++, record);/set(SORTED, s, record);/
