# Leaves out the keys that make no group.
# expect: was lost
s/^    for (; next < n; next++)/    for (; next < n \&\& !fits_group(k); next++)/
