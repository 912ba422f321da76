# Stops at the first box that does not meet across.
# expect: ends at the first box that begins too late
# why: Both tests are put into the condition of the loop.
s/s < n && begins_within(order\[r\], order\[s\]); s++)/s < n \&\& begins_within(order[r], order[s]) \&\& meet_across(order[r], order[s]); s++)/
