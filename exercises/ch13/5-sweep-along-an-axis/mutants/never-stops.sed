# Goes on to the last box.
# expect: need look only at few others
# why: The test is written as one of three, as for all pairs.
s/s < n && begins_within(order\[r\], order\[s\]); s++)/s < n; s++)/
s/if (meet_across(order\[r\], order\[s\]))/if (begins_within(order[r], order[s]) \&\& meet_across(order[r], order[s]))/
