# Leaves out the keys that make no group.
# expect: was lost
# why: The loop over groups ends, and nothing follows.
s/^    for (; next < n; next++)/    for (; next < n \&\& !fits_group(k); next++)/
