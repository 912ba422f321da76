# Keeps spans without points.
# expect: need not be a span
/if (begin == end)/,+1d
